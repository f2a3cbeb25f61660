#include "content/GltfReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "content/GltfAccessor.h"
#include "content/GltfDocument.h"

namespace aolib {
namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isTriangleMode(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Triangles from the corner list of a primitive; a strip turns every other triangle round.
std::vector<std::uint32_t> toTriangles(int mode, std::vector<std::uint32_t> corners) {
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        return corners;
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 2; i < corners.size(); ++i) {
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            result.insert(result.end(), {corners[0], corners[i - 1], corners[i]});
        } else if (i % 2 == 0) {
            result.insert(result.end(), {corners[i - 2], corners[i - 1], corners[i]});
        } else {
            result.insert(result.end(), {corners[i - 1], corners[i - 2], corners[i]});
        }
    }
    return result;
}

class GltfAssembler {
public:
    explicit GltfAssembler(const GltfDocument& document)
        : document_(document), gltf_(document.structure) {}

    Loaded<Model> assemble();

private:
    LoadError failure(const std::string& reason) const {
        return LoadError{document_.name + ": " + reason};
    }
    Loaded<std::vector<int>> rootNodes() const;
    Loaded<glm::mat4> localTransform(const tinygltf::Node& node, int index) const;
    std::optional<LoadError> visitNodes(Model& model);
    std::optional<LoadError> loadMesh(std::size_t index);
    Loaded<ModelMesh> loadPrimitive(const tinygltf::Primitive& primitive,
                                    const std::string& where) const;
    Loaded<std::vector<std::uint32_t>> cornersOf(const tinygltf::Primitive& primitive,
                                                 std::size_t vertexCount,
                                                 const std::string& where) const;
    std::optional<LoadError> readNormals(int accessor, ModelMesh& mesh,
                                         const std::string& where) const;
    void applyMaterial(int index, ModelMesh& mesh) const;
    std::optional<LoadError> placeMesh(const tinygltf::Node& node, int nodeIndex,
                                       const glm::mat4& transform, Model& model);

    const GltfDocument& document_;
    const tinygltf::Model& gltf_;
    std::vector<std::optional<std::vector<ModelMesh>>> meshes_; ///< read when first used
};

Loaded<std::vector<int>> GltfAssembler::rootNodes() const {
    if (!gltf_.scenes.empty()) {
        const int scene = gltf_.defaultScene < 0 ? 0 : gltf_.defaultScene;
        if (static_cast<std::size_t>(scene) >= gltf_.scenes.size()) {
            return failure("its default scene " + std::to_string(scene) + " does not exist");
        }
        return gltf_.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<char> isChild(gltf_.nodes.size(), 0);
    for (const tinygltf::Node& node : gltf_.nodes) {
        for (const int child : node.children) {
            if (child >= 0 && static_cast<std::size_t>(child) < isChild.size()) {
                isChild[static_cast<std::size_t>(child)] = 1;
            }
        }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < isChild.size(); ++i) {
        if (isChild[i] == 0) {
            roots.push_back(static_cast<int>(i));
        }
    }
    return roots;
}

Loaded<glm::mat4> GltfAssembler::localTransform(const tinygltf::Node& node, int index) const {
    const LoadError badSize = failure("node " + std::to_string(index) +
                                      " has a transform with the wrong number of values");
    if (!node.matrix.empty()) {
        if (node.matrix.size() != 16) {
            return badSize;
        }
        return glm::mat4(glm::make_mat4(node.matrix.data()));
    }
    if ((!node.translation.empty() && node.translation.size() != 3) ||
        (!node.rotation.empty() && node.rotation.size() != 4) ||
        (!node.scale.empty() && node.scale.size() != 3)) {
        return badSize;
    }
    glm::dmat4 result(1.0);
    if (!node.rotation.empty()) {
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1],
                                  node.rotation[2]);
        if (!(glm::length(rotation) > 0.0)) {
            return failure("node " + std::to_string(index) + " has a rotation of length zero");
        }
        result = glm::mat4_cast(glm::normalize(rotation));
    }
    for (int axis = 0; axis < 3 && !node.scale.empty(); ++axis) {
        result[axis] *= node.scale[static_cast<std::size_t>(axis)];
    }
    if (!node.translation.empty()) {
        result[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
    }
    return glm::mat4(result);
}

std::optional<LoadError> GltfAssembler::visitNodes(Model& model) {
    const Loaded<std::vector<int>> roots = rootNodes();
    if (!roots) {
        return roots.error();
    }
    std::vector<std::pair<int, glm::mat4>> waiting;
    for (auto root = roots->rbegin(); root != roots->rend(); ++root) {
        waiting.emplace_back(*root, glm::mat4(1.0F));
    }
    std::vector<char> visited(gltf_.nodes.size(), 0);
    while (!waiting.empty()) {
        const auto [index, parent] = waiting.back();
        waiting.pop_back();
        if (index < 0 || static_cast<std::size_t>(index) >= gltf_.nodes.size()) {
            return failure("node " + std::to_string(index) + " does not exist");
        }
        if (std::exchange(visited[static_cast<std::size_t>(index)], char{1}) != 0) {
            return failure("node " + std::to_string(index) +
                           " is reached twice, so its scene is not a tree");
        }
        const tinygltf::Node& node = gltf_.nodes[static_cast<std::size_t>(index)];
        const Loaded<glm::mat4> local = localTransform(node, index);
        if (!local) {
            return local.error();
        }
        const glm::mat4 transform = parent * *local;
        if (std::optional<LoadError> error = placeMesh(node, index, transform, model)) {
            return error;
        }
        for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
            waiting.emplace_back(*child, transform);
        }
    }
    return std::nullopt;
}

std::optional<LoadError> GltfAssembler::placeMesh(const tinygltf::Node& node, int nodeIndex,
                                                  const glm::mat4& transform, Model& model) {
    if (node.mesh == -1) {
        return std::nullopt;
    }
    if (node.mesh < 0 || static_cast<std::size_t>(node.mesh) >= gltf_.meshes.size()) {
        return failure("node " + std::to_string(nodeIndex) + " names mesh " +
                       std::to_string(node.mesh) + ", which does not exist");
    }
    const auto meshIndex = static_cast<std::size_t>(node.mesh);
    if (std::optional<LoadError> error = loadMesh(meshIndex)) {
        return error;
    }
    for (const ModelMesh& mesh : *meshes_[meshIndex]) {
        const bool placed =
            std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const glm::vec3& p) {
                return finite(glm::vec3(transform * glm::vec4(p, 1.0F)));
            });
        if (!placed) {
            return failure("node " + std::to_string(nodeIndex) +
                           " moves vertices to where they are not finite");
        }
        model.meshes.push_back(mesh);
        model.meshes.back().transform = transform;
        if (!node.name.empty()) {
            model.meshes.back().name = node.name;
        }
    }
    return std::nullopt;
}

std::optional<LoadError> GltfAssembler::loadMesh(std::size_t index) {
    if (meshes_[index]) {
        return std::nullopt;
    }
    std::vector<ModelMesh> parts;
    const tinygltf::Mesh& source = gltf_.meshes[index];
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const tinygltf::Primitive& primitive = source.primitives[i];
        if (!isTriangleMode(primitive.mode) || primitive.attributes.count("POSITION") == 0) {
            continue;
        }
        const std::string where =
            "mesh " + std::to_string(index) + ", primitive " + std::to_string(i);
        Loaded<ModelMesh> mesh = loadPrimitive(primitive, where);
        if (!mesh) {
            return mesh.error();
        }
        mesh->name = source.name.empty() ? "mesh " + std::to_string(index) : source.name;
        if (!mesh->indices.empty()) {
            parts.push_back(std::move(*mesh));
        }
    }
    meshes_[index] = std::move(parts);
    return std::nullopt;
}

Loaded<std::vector<std::uint32_t>> GltfAssembler::cornersOf(const tinygltf::Primitive& primitive,
                                                            std::size_t vertexCount,
                                                            const std::string& where) const {
    Loaded<std::vector<std::uint32_t>> corners = std::vector<std::uint32_t>();
    if (primitive.indices >= 0) {
        corners = readIndices(document_, primitive.indices);
    } else {
        corners->resize(vertexCount);
        for (std::size_t i = 0; i < vertexCount; ++i) {
            (*corners)[i] = static_cast<std::uint32_t>(i);
        }
    }
    if (!corners) {
        return corners;
    }
    for (const std::uint32_t corner : *corners) {
        if (corner >= vertexCount) {
            return failure(where + ": index " + std::to_string(corner) + " names none of " +
                           std::to_string(vertexCount) + " vertices");
        }
    }
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES && corners->size() % 3 != 0) {
        return failure(where + ": " + std::to_string(corners->size()) +
                       " corners do not make whole triangles");
    }
    return corners;
}

Loaded<ModelMesh> GltfAssembler::loadPrimitive(const tinygltf::Primitive& primitive,
                                               const std::string& where) const {
    ModelMesh mesh;
    Loaded<std::vector<glm::vec3>> positions =
        readVectors(document_, primitive.attributes.at("POSITION"));
    if (!positions) {
        return positions.error();
    }
    mesh.positions = std::move(*positions);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!finite(mesh.positions[i])) {
            return failure(where + ": the position of vertex " + std::to_string(i) +
                           " is not finite");
        }
    }
    Loaded<std::vector<std::uint32_t>> corners = cornersOf(primitive, mesh.positions.size(), where);
    if (!corners) {
        return corners.error();
    }
    mesh.indices = toTriangles(primitive.mode, std::move(*corners));
    const auto normals = primitive.attributes.find("NORMAL");
    if (normals != primitive.attributes.end()) {
        if (std::optional<LoadError> error = readNormals(normals->second, mesh, where)) {
            return *error;
        }
    }
    applyMaterial(primitive.material, mesh);
    return mesh;
}

/// Normals of length zero are replaced by the mean of the faces about the vertex.
std::optional<LoadError> GltfAssembler::readNormals(int accessor, ModelMesh& mesh,
                                                    const std::string& where) const {
    Loaded<std::vector<glm::vec3>> normals = readVectors(document_, accessor);
    if (!normals) {
        return normals.error();
    }
    if (normals->size() != mesh.positions.size()) {
        return failure(where + ": " + std::to_string(normals->size()) + " normals for " +
                       std::to_string(mesh.positions.size()) + " positions");
    }
    std::vector<glm::vec3> substitutes;
    for (std::size_t i = 0; i < normals->size(); ++i) {
        glm::vec3& normal = (*normals)[i];
        const float length = glm::length(normal);
        if (!std::isfinite(length)) {
            return failure(where + ": the normal of vertex " + std::to_string(i) +
                           " is not finite");
        }
        if (length > 0.0F) {
            normal /= length;
            continue;
        }
        if (substitutes.empty()) {
            substitutes = smoothNormals(mesh.positions, mesh.indices);
        }
        normal = substitutes[i];
    }
    mesh.normals = std::move(*normals);
    return std::nullopt;
}

void GltfAssembler::applyMaterial(int index, ModelMesh& mesh) const {
    if (index < 0 || static_cast<std::size_t>(index) >= gltf_.materials.size()) {
        return;
    }
    const tinygltf::Material& material = gltf_.materials[static_cast<std::size_t>(index)];
    mesh.doubleSided = material.doubleSided;
    const std::vector<double>& factor = material.pbrMetallicRoughness.baseColorFactor;
    for (std::size_t channel = 0; channel < 4 && factor.size() == 4; ++channel) {
        mesh.baseColour[static_cast<int>(channel)] =
            static_cast<float>(std::clamp(factor[channel], 0.0, 1.0));
    }
}

Loaded<Model> GltfAssembler::assemble() {
    meshes_.resize(gltf_.meshes.size());
    Model model;
    if (std::optional<LoadError> error = visitNodes(model)) {
        return *error;
    }
    return model;
}

} // namespace

Loaded<Model> readGltf(std::string_view bytes, const std::filesystem::path& file) {
    const Loaded<GltfDocument> document = parseGltf(bytes, file);
    if (!document) {
        return document.error();
    }
    return GltfAssembler(*document).assemble();
}

} // namespace aolib
