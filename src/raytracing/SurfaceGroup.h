#pragma once

#include <array>
#include <cstddef>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "raytracing/SobolSequence.h"

namespace aolib {

/// Where rays of one texel start.
struct TexelSurface {
    glm::vec3 origin{0.0F}; ///< in the scene's frame, above the surface
    glm::mat3 basis{1.0F};  ///< orthonormal; the third column is the normal
    SequenceSeed seed;
    std::size_t texel = 0; ///< its place in the request
};

/// Texels whose rays are traced side by side.
struct SurfaceGroup {
    static constexpr std::size_t capacity = 16;

    std::array<TexelSurface, capacity> surfaces;
    std::size_t count = 0;

    void add(const TexelSurface& surface) { surfaces[count++] = surface; }
    bool full() const { return count == capacity; }
};

} // namespace aolib
