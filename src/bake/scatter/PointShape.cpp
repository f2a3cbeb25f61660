#include "bake/scatter/PointShape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bake/geometry/UvMetric.h"
#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

namespace {

// As in shaders/bake/footprint.glsl.
constexpr double largest = 128.0;
constexpr double stretched = 2.0;
constexpr double longer = 3.0;

/// The lengths of the gradients of u and v on a triangle, times a pixel's side.
glm::dvec2 footprint(const Surface& surface, std::uint32_t triangle, const PointSettings& settings,
                     double scale) {
    const auto [t1, t2, xx, xy, yy, determinant] =
        UvMetric::of(surface, triangle, glm::dvec2(settings.mapSize), scale);
    if (!(determinant > 0.0)) {
        return glm::dvec2(0.0);
    }
    const glm::dvec2 squares = (yy * t1 * t1 - 2.0 * xy * t1 * t2 + xx * t2 * t2) / determinant;
    const glm::dvec2 sides =
        double{settings.pixelSize} * glm::sqrt(glm::max(squares, glm::dvec2(0.0)));
    glm::dvec2 result;
    for (int axis = 0; axis < 2; ++axis) {
        const bool isLong = sides[axis] > stretched * std::max(sides[1 - axis], 1.0);
        result[axis] = std::min((isLong ? longer : 1.0) * sides[axis], largest);
    }
    return result;
}

} // namespace

std::vector<PointShape> pointShapes(const BakeGeometry& geometry, const BakeFrame& frame,
                                    const Facets& facets, const PointSettings& settings) {
    std::vector<PointShape> shapes(geometry.triangleCount());
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Surface& surface = surfaces[s];
        const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
        for (std::uint32_t t = 0; surface.map >= 0 && t < triangles; ++t) {
            if (uvFault(surface, t, glm::dvec2(settings.mapSize)) != UvFault::None) {
                continue;
            }
            PointShape& shape = shapes[geometry.numberOf({s, t})];
            shape.map = surface.map;
            shape.facet = facets.ofTriangle(geometry.scene(), {s, t});
            if (settings.pointSize > 0.0F) {
                const glm::dvec2 sides = footprint(surface, t, settings, frame.scale());
                shape.sides = glm::max(glm::vec2(sides), glm::vec2(settings.pointSize));
            }
        }
    }
    return shapes;
}

} // namespace aolib::bake
