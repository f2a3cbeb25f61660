#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace aolib {

/// Indexed triangles in world space: the form in which the truth, the bakers and the tools read a
/// scene. `indices.size()` is a multiple of 3; `normals` is empty or as long as `positions`.
struct TriangleMesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;

    std::size_t triangleCount() const { return indices.size() / 3; }
};

} // namespace aolib
