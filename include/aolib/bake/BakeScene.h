#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib::bake {

/// Triangles in world space, which occlude, and whose occlusion is baked. Since 0.1.
struct Surface {
    std::vector<glm::vec3> positions; ///< world units, finite
    std::vector<glm::vec3> normals;   ///< one per position, or empty for the triangles' normals,
                                      ///< which also replace those that are zero or not finite
    std::vector<glm::vec2> uvs; ///< empty or one per position, in [0,1], v upwards; triangles with
                                ///< UVs outside get no texels and are counted by checkUvs()
    std::vector<std::uint32_t>
        indices; ///< three per triangle; triangles without area occlude nothing
    int map = 0; ///< number of the map that gets its texels, from 0; -1: it only occludes
};

/// The surfaces that are baked together, and occlude each other. Since 0.1.
struct BakeScene {
    std::vector<Surface> surfaces;
    glm::vec3 up{0.0F, 1.0F, 0.0F}; ///< of the ground and of `Sky::Dome`, any length but zero
    /// Distance of an infinite ground plane from the origin along `up`, world units; it occludes.
    std::optional<float> ground;

    /// Returns the number of maps: one more than the highest number of a map.
    int mapCount() const {
        int count = 0;
        for (const Surface& surface : surfaces) {
            count = surface.map >= count ? surface.map + 1 : count;
        }
        return count;
    }
};

} // namespace aolib::bake
