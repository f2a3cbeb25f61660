#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

/// Triangles as hosts have them: one normal per position, three indices per triangle.
struct Triangles {
    std::vector<glm::vec3> positions; ///< world units
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
};

/// A ground of 16 by 16 units about the origin, with a few boxes on it and on each other.
Triangles groundWithBoxes();
