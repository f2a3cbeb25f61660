#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <aolib/Scene.h>
#include <aolib/Status.h>

#include "scene/Bounds.h"
#include "scene/Finite.h"

namespace aolib {

/// A mesh as the scene keeps it: indexed triangles in model space and where they stand.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< empty, or one per position
    std::vector<std::uint32_t> indices;
    glm::mat4 transform{1.0F};
    Bounds modelBounds;

    Bounds worldBounds() const { return transformed(modelBounds, transform); }
};

/// Checks a mesh given in bulk and copies it. Errors: InvalidPosition, InvalidNormal, InvalidIndex,
/// IncompletePrimitive, EmptyMesh.
Result<Mesh> makeMesh(const MeshData& data);

/// Ok if every element of the matrix is finite. Errors: InvalidPosition.
AoStatus checkTransform(const glm::mat4& transform);

} // namespace aolib
