#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib::bake {

/// Triangles in world space that occlude, and whose occlusion is wanted. Since 0.1.
struct Surface {
    std::vector<glm::vec3> positions; ///< world units, finite
    std::vector<glm::vec3> normals;   ///< empty (the triangles' own are taken) or one per position;
                                      ///< a zero or not finite one is replaced by the triangle's
    std::vector<glm::vec2> uvs; ///< empty or one per position, in [0,1], v upwards; triangles with
                                ///< others get no texels and are counted by checkUvs()
    std::vector<std::uint32_t> indices; ///< triangles; those without area occlude nothing
    int map = 0; ///< number of the map that its texels go to, from 0; -1: it only occludes
};

/// What is baked together. Since 0.1.
struct BakeScene {
    std::vector<Surface> surfaces;
    glm::vec3 up{0.0F, 1.0F, 0.0F}; ///< of the ground and of `Sky::Dome`, any length but zero
    /// A ground this far along `up` from the origin, world units, as an endless occluder.
    std::optional<float> ground;

    /// The highest number of a map and one.
    int mapCount() const {
        int count = 0;
        for (const Surface& surface : surfaces) {
            count = surface.map >= count ? surface.map + 1 : count;
        }
        return count;
    }
};

} // namespace aolib::bake
