#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "content/GltfDocument.h"
#include "content/LoadError.h"

namespace aolib {

/// A skeleton that a mesh hangs on.
struct GltfSkin {
    std::vector<int> joints;         ///< nodes
    std::vector<glm::mat4> fromMesh; ///< the mesh's space to each joint's
};

/// Which joints move a vertex, and how much.
struct GltfVertexJoints {
    std::vector<glm::vec4> joints; ///< numbers in the skin, as many as there are vertices
    std::vector<glm::vec4> weights;
};

/// A skin by its number. Fails on missing nodes and matrices that do not fit.
Result<GltfSkin, LoadError> readSkin(const GltfDocument& document, int skin);

/// Every set of joints that a primitive has (JOINTS_0, JOINTS_1, ...). Fails where numbers do not
/// fit vertices or name none of the skin's joints.
Result<std::vector<GltfVertexJoints>, LoadError>
readVertexJoints(const GltfDocument& document, const tinygltf::Primitive& primitive,
                 std::size_t vertices, std::size_t joints);

} // namespace aolib
