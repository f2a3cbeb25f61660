#include "content/GltfSkin.h"

#include <string>
#include <utility>

#include "content/GltfAccessor.h"

namespace aolib {

Result<GltfSkin, LoadError> readSkin(const GltfDocument& document, int skin) {
    const auto& skins = document.structure.skins;
    const std::string where = document.name + ": skin " + std::to_string(skin);
    if (skin < 0 || static_cast<std::size_t>(skin) >= skins.size()) {
        return LoadError{where + " does not exist"};
    }
    const tinygltf::Skin& source = skins[static_cast<std::size_t>(skin)];
    GltfSkin result;
    result.joints = source.joints;
    for (const int joint : result.joints) {
        if (joint < 0 || static_cast<std::size_t>(joint) >= document.structure.nodes.size()) {
            return LoadError{where + " names node " + std::to_string(joint) +
                             ", which does not exist"};
        }
    }
    result.fromMesh.assign(result.joints.size(), glm::mat4(1.0F));
    if (source.inverseBindMatrices >= 0) {
        Result<std::vector<glm::mat4>, LoadError> matrices =
            readMatrices(document, source.inverseBindMatrices);
        if (!matrices) {
            return matrices.error();
        }
        if (matrices->size() < result.joints.size()) {
            return LoadError{where + " has " + std::to_string(matrices->size()) + " matrices for " +
                             std::to_string(result.joints.size()) + " joints"};
        }
        result.fromMesh = std::move(*matrices);
    }
    return result;
}

Result<std::vector<GltfVertexJoints>, LoadError>
readVertexJoints(const GltfDocument& document, const tinygltf::Primitive& primitive,
                 std::size_t vertices, std::size_t joints) {
    std::vector<GltfVertexJoints> sets;
    for (;;) {
        const std::string number = std::to_string(sets.size());
        const auto names = primitive.attributes.find("JOINTS_" + number);
        const auto weights = primitive.attributes.find("WEIGHTS_" + number);
        if (names == primitive.attributes.end() || weights == primitive.attributes.end()) {
            return sets;
        }
        Result<std::vector<glm::vec4>, LoadError> first = readQuads(document, names->second);
        if (!first) {
            return first.error();
        }
        Result<std::vector<glm::vec4>, LoadError> second = readQuads(document, weights->second);
        if (!second) {
            return second.error();
        }
        if (first->size() != vertices || second->size() != vertices) {
            return LoadError{document.name + ": JOINTS_" + number + " and WEIGHTS_" + number +
                             " have " + std::to_string(first->size()) + " and " +
                             std::to_string(second->size()) + " values for " +
                             std::to_string(vertices) + " positions"};
        }
        for (const glm::vec4& four : *first) {
            for (int i = 0; i < 4; ++i) {
                if (!(four[i] >= 0.0F && four[i] < static_cast<float>(joints))) {
                    return LoadError{document.name + ": JOINTS_" + number +
                                     " names none of the skin's " + std::to_string(joints) +
                                     " joints"};
                }
            }
        }
        sets.push_back({std::move(*first), std::move(*second)});
    }
}

} // namespace aolib
