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
    glm::mat3 basis{1.0F};  ///< orthonormal; the third column is the shading normal
    glm::vec3 plane{0.0F};  ///< the triangle's own normal, on the same side, where it is another:
                            ///< rays below that plane are blocked; else 0
    SequenceSeed seed;
    std::size_t texel = 0; ///< its place in the request
};

/// Texels whose rays are traced side by side.
struct SurfaceGroup {
    static constexpr std::size_t capacity = 16;

    std::array<TexelSurface, capacity> surfaces;
    std::size_t count = 0;
    bool planes = false; ///< some surface has a plane

    void add(const TexelSurface& surface) {
        surfaces[count++] = surface;
        planes = planes || surface.plane != glm::vec3(0.0F);
    }
    void clear() {
        count = 0;
        planes = false;
    }
    bool full() const { return count == capacity; }
};

} // namespace aolib
