#include "bake/scatter/TexelDensity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "bake/geometry/UvMetric.h"
#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

namespace {

/// A triangle's share of the maps, square texels, and texels along a frame unit.
struct Density {
    double along;
    double area;
};

Density computeDensity(const Surface& surface, std::uint32_t triangle, const glm::dvec2& mapSize,
                       double scale) {
    const auto [t1, t2, xx, xy, yy, determinant] = UvMetric::of(surface, triangle, mapSize, scale);
    const double area = 0.5 * std::abs(t1.x * t2.y - t1.y * t2.x);
    if (determinant <= 0.0) {
        return {0.0, 0.0};
    }
    // Trace and determinant of the squared map from the surface to texels; its smaller eigenvalue.
    const double trace =
        (yy * glm::dot(t1, t1) - 2.0 * xy * glm::dot(t1, t2) + xx * glm::dot(t2, t2)) / determinant;
    const double product = 4.0 * area * area / determinant;
    const double root = std::sqrt(std::max(0.0, 0.25 * trace * trace - product));
    return {std::sqrt(std::max(0.0, 0.5 * trace - root)), area};
}

} // namespace

double texelsAlongUnit(const BakeGeometry& geometry, const BakeFrame& frame,
                       const glm::dvec2& mapSize, double share) {
    std::vector<Density> densities;
    double total = 0.0;
    for (const Surface& surface : geometry.scene().surfaces) {
        const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
        for (std::uint32_t t = 0; surface.map >= 0 && t < triangles; ++t) {
            if (uvFault(surface, t, mapSize) != UvFault::None) {
                continue;
            }
            const Density density = computeDensity(surface, t, mapSize, frame.scale());
            if (density.area > 0.0) {
                densities.push_back(density);
                total += density.area;
            }
        }
    }
    std::sort(densities.begin(), densities.end(),
              [](const Density& a, const Density& b) { return a.along < b.along; });
    double before = 0.0;
    for (const Density& density : densities) {
        before += density.area;
        if (before >= share * total) {
            return density.along;
        }
    }
    return densities.empty() ? 0.0 : densities.back().along;
}

} // namespace aolib::bake
