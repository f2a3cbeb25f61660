#include "content/GltfReader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "content/GltfDocument.h"
#include "content/GltfMesh.h"

namespace aolib {
namespace {

class GltfAssembler {
public:
    explicit GltfAssembler(const GltfDocument& document)
        : document_(document), gltf_(document.structure) {}

    Result<Model, LoadError> assemble();

private:
    LoadError failure(const std::string& reason) const {
        return LoadError{document_.name + ": " + reason};
    }
    Result<std::vector<int>, LoadError> rootNodes() const;
    Result<glm::mat4, LoadError> localTransform(const tinygltf::Node& node, int index) const;
    std::optional<LoadError> visitNodes(Model& model);
    std::optional<LoadError> placeMesh(const tinygltf::Node& node, int nodeIndex,
                                       const glm::mat4& transform, Model& model);

    const GltfDocument& document_;
    const tinygltf::Model& gltf_;
    std::vector<std::optional<std::vector<ModelMesh>>> meshes_; ///< read when first used
};

Result<std::vector<int>, LoadError> GltfAssembler::rootNodes() const {
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

Result<glm::mat4, LoadError> GltfAssembler::localTransform(const tinygltf::Node& node,
                                                           int index) const {
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
    const Result<std::vector<int>, LoadError> roots = rootNodes();
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
        const Result<glm::mat4, LoadError> local = localTransform(node, index);
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
    if (!meshes_[meshIndex]) {
        Result<std::vector<ModelMesh>, LoadError> parts = readGltfMesh(document_, meshIndex);
        if (!parts) {
            return parts.error();
        }
        meshes_[meshIndex] = std::move(*parts);
    }
    for (const ModelMesh& mesh : *meshes_[meshIndex]) {
        const bool placed =
            std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const glm::vec3& p) {
                return isFinite(glm::vec3(transform * glm::vec4(p, 1.0F)));
            });
        if (!placed) {
            return failure("node " + std::to_string(nodeIndex) +
                           " moves vertices to where they are not finite");
        }
        model.meshes.push_back(mesh);
        model.meshes.back().transform = transform;
        model.meshes.back().origin.node = nodeIndex;
        if (!node.name.empty()) {
            model.meshes.back().name = node.name;
        }
    }
    return std::nullopt;
}

Result<Model, LoadError> GltfAssembler::assemble() {
    meshes_.resize(gltf_.meshes.size());
    Model model;
    if (std::optional<LoadError> error = visitNodes(model)) {
        return *error;
    }
    return model;
}

} // namespace

Result<Model, LoadError> readGltf(std::string_view bytes, const std::filesystem::path& file) {
    const Result<GltfDocument, LoadError> document = parseGltf(bytes, file);
    if (!document) {
        return document.error();
    }
    return GltfAssembler(*document).assemble();
}

} // namespace aolib
