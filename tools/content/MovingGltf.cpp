#include "content/MovingGltf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "content/GltfAccessor.h"
#include "content/GltfReader.h"
#include "scene/Finite.h"

namespace aolib {

/// What the tracks of an animation say at a time, by node and property.
struct MovingGltf::Pose {
    std::map<std::pair<int, GltfTrack::Path>, std::vector<double>> values;

    const std::vector<double>* find(int node, GltfTrack::Path path) const {
        const auto found = values.find({node, path});
        return found == values.end() ? nullptr : &found->second;
    }
};

Result<MovingGltf, LoadError> MovingGltf::open(std::string_view bytes,
                                               const std::filesystem::path& file) {
    Result<Model, LoadError> rest = readGltf(bytes, file);
    if (!rest) {
        return rest.error();
    }
    Result<GltfDocument, LoadError> document = parseGltf(bytes, file, GltfMotion::Parsed);
    if (!document) {
        return document.error();
    }
    Result<std::vector<GltfAnimation>, LoadError> animations = readAnimations(*document);
    if (!animations) {
        return animations.error();
    }
    MovingGltf moving;
    const auto& nodes = document->structure.nodes;
    moving.parents_.assign(nodes.size(), -1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const int child : nodes[i].children) {
            if (child >= 0 && static_cast<std::size_t>(child) < nodes.size()) {
                moving.parents_[static_cast<std::size_t>(child)] = static_cast<int>(i);
            }
        }
    }
    moving.document_ = std::move(*document);
    moving.rest_ = std::move(*rest);
    moving.animations_ = std::move(*animations);
    return moving;
}

double MovingGltf::duration(std::size_t animation) const {
    double last = 0.0;
    for (const GltfTrack& track : animations_[animation]) {
        last = std::max(last, double{track.times.back()});
    }
    return last;
}

std::vector<float> MovingGltf::parameters(std::size_t animation, double seconds) const {
    std::vector<float> numbers;
    for (const GltfTrack& track : animations_[animation]) {
        for (const double value : track.at(seconds)) {
            numbers.push_back(static_cast<float>(value));
        }
    }
    return numbers;
}

Result<glm::dmat4, LoadError> MovingGltf::localTransform(const Pose& pose,
                                                         std::size_t number) const {
    const tinygltf::Node& node = document_.structure.nodes[number];
    const int index = static_cast<int>(number);
    const auto* moved = pose.find(index, GltfTrack::Path::Translation);
    const auto* turned = pose.find(index, GltfTrack::Path::Rotation);
    const auto* scaled = pose.find(index, GltfTrack::Path::Scale);
    if (moved == nullptr && turned == nullptr && scaled == nullptr && node.matrix.size() == 16) {
        return glm::make_mat4(node.matrix.data());
    }
    const auto chosen = [](const std::vector<double>* animated, const std::vector<double>& own,
                           std::vector<double> otherwise) {
        const std::vector<double>& given = animated != nullptr ? *animated : own;
        return given.size() == otherwise.size() ? given : otherwise;
    };
    const std::vector<double> translation = chosen(moved, node.translation, {0.0, 0.0, 0.0});
    const std::vector<double> rotation = chosen(turned, node.rotation, {0.0, 0.0, 0.0, 1.0});
    const std::vector<double> scale = chosen(scaled, node.scale, {1.0, 1.0, 1.0});
    const glm::dquat quaternion(rotation[3], rotation[0], rotation[1], rotation[2]);
    if (!(glm::length(quaternion) > 0.0)) {
        return LoadError{document_.name + ": node " + std::to_string(number) +
                         " has a rotation of length zero"};
    }
    glm::dmat4 result = glm::mat4_cast(glm::normalize(quaternion));
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] *= scale[static_cast<std::size_t>(axis)];
    }
    result[3] = glm::dvec4(translation[0], translation[1], translation[2], 1.0);
    return result;
}

Result<std::vector<glm::mat4>, LoadError> MovingGltf::worldTransforms(const Pose& pose) const {
    std::vector<glm::dmat4> local;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
        const Result<glm::dmat4, LoadError> transform = localTransform(pose, i);
        if (!transform) {
            return transform.error();
        }
        local.push_back(*transform);
    }
    std::vector<glm::mat4> world;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
        glm::dmat4 transform = local[i];
        std::size_t steps = 0;
        for (int up = parents_[i]; up >= 0; up = parents_[static_cast<std::size_t>(up)]) {
            if (++steps > parents_.size()) {
                return LoadError{document_.name + ": node " + std::to_string(i) +
                                 " is its own ancestor"};
            }
            transform = local[static_cast<std::size_t>(up)] * transform;
        }
        world.emplace_back(transform);
    }
    return world;
}

const tinygltf::Primitive& MovingGltf::primitiveOf(const ModelMesh& mesh) const {
    return document_.structure.meshes[static_cast<std::size_t>(mesh.origin.mesh)]
        .primitives[static_cast<std::size_t>(mesh.origin.primitive)];
}

Result<bool, LoadError> MovingGltf::morph(ModelMesh& mesh,
                                          const std::vector<double>& weights) const {
    const tinygltf::Primitive& primitive = primitiveOf(mesh);
    const auto add = [&](int accessor, float weight,
                         std::vector<glm::vec3>& values) -> Result<bool, LoadError> {
        const Result<std::vector<glm::vec3>, LoadError> offsets = readVectors(document_, accessor);
        if (!offsets) {
            return offsets.error();
        }
        if (offsets->size() != values.size()) {
            return LoadError{document_.name + ": a morph target has " +
                             std::to_string(offsets->size()) + " values for " +
                             std::to_string(values.size()) + " vertices"};
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] += weight * (*offsets)[i];
        }
        return true;
    };
    const std::size_t count = std::min(weights.size(), primitive.targets.size());
    for (std::size_t i = 0; i < count; ++i) {
        const auto weight = static_cast<float>(weights[i]);
        for (const auto& [name, accessor] : primitive.targets[i]) {
            std::vector<glm::vec3>* values = name == "POSITION" ? &mesh.positions
                                             : name == "NORMAL" ? &mesh.normals
                                                                : nullptr;
            if (weight == 0.0F || values == nullptr || values->empty()) {
                continue;
            }
            if (Result<bool, LoadError> added = add(accessor, weight, *values); !added) {
                return added;
            }
        }
    }
    return true;
}

Result<bool, LoadError> MovingGltf::bend(ModelMesh& mesh, int number,
                                         const std::vector<glm::mat4>& world,
                                         std::vector<glm::mat3>& toWorld) const {
    const Result<GltfSkin, LoadError> skin = readSkin(document_, number);
    if (!skin) {
        return skin.error();
    }
    const auto sets =
        readVertexJoints(document_, primitiveOf(mesh), mesh.positions.size(), skin->joints.size());
    if (!sets) {
        return sets.error();
    }
    std::vector<glm::mat4> joints;
    for (std::size_t i = 0; i < skin->joints.size(); ++i) {
        joints.push_back(world[static_cast<std::size_t>(skin->joints[i])] * skin->fromMesh[i]);
    }
    toWorld.assign(mesh.positions.size(), glm::mat3(1.0F));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::mat4 blended(0.0F);
        float sum = 0.0F;
        for (const GltfVertexJoints& set : *sets) {
            for (int i = 0; i < 4; ++i) {
                const float weight = set.weights[v][i];
                blended += weight * joints[static_cast<std::size_t>(set.joints[v][i])];
                sum += weight;
            }
        }
        if (!(sum > 0.0F)) {
            continue; // nothing holds it: it stays where it is
        }
        blended /= sum;
        toWorld[v] = glm::mat3(blended);
        mesh.positions[v] = glm::vec3(blended * glm::vec4(mesh.positions[v], 1.0F));
        if (!mesh.normals.empty()) {
            mesh.normals[v] = glm::inverseTranspose(glm::mat3(blended)) * mesh.normals[v];
        }
    }
    mesh.transform = glm::mat4(1.0F);
    return true;
}

Result<ModelMesh, LoadError> MovingGltf::posed(const ModelMesh& mesh, const Pose& pose,
                                               const std::vector<glm::mat4>& world,
                                               std::vector<glm::mat3>& toWorld) const {
    ModelMesh result = mesh;
    const tinygltf::Node& node =
        document_.structure.nodes[static_cast<std::size_t>(mesh.origin.node)];
    result.transform = world[static_cast<std::size_t>(mesh.origin.node)];
    toWorld = {glm::mat3(result.transform)};
    const auto* weights = pose.find(mesh.origin.node, GltfTrack::Path::Weights);
    const std::vector<double>& own =
        node.weights.empty()
            ? document_.structure.meshes[static_cast<std::size_t>(mesh.origin.mesh)].weights
            : node.weights;
    if (Result<bool, LoadError> done = morph(result, weights != nullptr ? *weights : own); !done) {
        return done.error();
    }
    if (node.skin >= 0) {
        if (Result<bool, LoadError> done = bend(result, node.skin, world, toWorld); !done) {
            return done.error();
        }
    }
    for (std::size_t i = 0; i < result.positions.size(); ++i) {
        if (!isFinite(glm::vec3(result.transform * glm::vec4(result.positions[i], 1.0F)))) {
            return LoadError{document_.name + ": a pose moves vertices to where they are not "
                                              "finite"};
        }
        if (!result.normals.empty()) {
            const float length = glm::length(result.normals[i]);
            result.normals[i] = std::isfinite(length) && length > 0.0F ? result.normals[i] / length
                                                                       : mesh.normals[i];
        }
    }
    return result;
}

Result<Model, LoadError> MovingGltf::at(std::size_t animation, double seconds) const {
    Result<PosedModel, LoadError> posed = posedAt(animation, seconds);
    return posed ? Result<Model, LoadError>(std::move(posed->model)) : posed.error();
}

Result<PosedModel, LoadError> MovingGltf::posedAt(std::size_t animation, double seconds) const {
    Pose pose;
    if (animation < animations_.size()) {
        for (const GltfTrack& track : animations_[animation]) {
            pose.values[{track.node, track.path}] = track.at(seconds);
        }
    }
    const Result<std::vector<glm::mat4>, LoadError> world = worldTransforms(pose);
    if (!world) {
        return world.error();
    }
    PosedModel result;
    result.model.name = rest_.name;
    for (const ModelMesh& mesh : rest_.meshes) {
        Result<ModelMesh, LoadError> moved =
            posed(mesh, pose, *world, result.toWorld.emplace_back());
        if (!moved) {
            return moved.error();
        }
        result.model.meshes.push_back(std::move(*moved));
    }
    return result;
}

glm::vec3 PosedModel::atRest(std::size_t mesh, std::size_t vertex,
                             const glm::vec3& direction) const {
    const std::vector<glm::mat3>& matrices = toWorld[mesh];
    // The inverse transpose takes normals to the world.
    const glm::vec3 local =
        glm::transpose(matrices.size() == 1 ? matrices[0] : matrices[vertex]) * direction;
    const float length = glm::length(local);
    return length > 0.0F ? local / length : glm::vec3(0.0F, 1.0F, 0.0F);
}

} // namespace aolib
