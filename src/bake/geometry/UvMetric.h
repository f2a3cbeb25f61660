#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/bake/AbstractBaker.h>

namespace aolib::bake {

/// How a triangle lies in the map: two of its edges there, and the first fundamental form of the
/// same two on the surface.
struct UvMetric {
    glm::dvec2 t1{0.0}; ///< edges in the map, texels
    glm::dvec2 t2{0.0};
    double xx = 0.0; ///< dot products of the edges on the surface
    double xy = 0.0;
    double yy = 0.0;
    double determinant = 0.0; ///< not above 0 where the triangle has no area

    /// @param mapSize  texels across and up
    /// @param scale    of the surface's lengths
    static UvMetric of(const Surface& surface, std::uint32_t triangle, const glm::dvec2& mapSize,
                       double scale) {
        const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
        const auto edge = [&](std::size_t k) {
            return scale * (glm::dvec3(surface.positions[index[k]]) -
                            glm::dvec3(surface.positions[index[0]]));
        };
        const auto texels = [&](std::size_t k) {
            return mapSize *
                   (glm::dvec2(surface.uvs[index[k]]) - glm::dvec2(surface.uvs[index[0]]));
        };
        const glm::dvec3 e1 = edge(1);
        const glm::dvec3 e2 = edge(2);
        UvMetric metric{.t1 = texels(1),
                        .t2 = texels(2),
                        .xx = glm::dot(e1, e1),
                        .xy = glm::dot(e1, e2),
                        .yy = glm::dot(e2, e2)};
        metric.determinant = metric.xx * metric.yy - metric.xy * metric.xy;
        return metric;
    }
};

} // namespace aolib::bake
