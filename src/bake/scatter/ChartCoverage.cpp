#include "bake/scatter/ChartCoverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

#include "raytracing/SobolSequence.h"

namespace aolib::bake {

namespace {

/// A triangle in the target, texels.
struct ChartTriangle {
    std::array<glm::dvec2, 3> p;

    /// The range of a row across the triangle, both ends the same for triangles that share an
    /// edge; empty (first > second) where the row misses it.
    std::pair<double, double> across(double y) const {
        std::pair<double, double> range(INFINITY, -INFINITY);
        for (std::size_t i = 0; i < 3; ++i) {
            glm::dvec2 a = p[i];
            glm::dvec2 b = p[(i + 1) % 3];
            if (b.y < a.y) {
                std::swap(a, b);
            }
            if (a.y <= y && y < b.y) {
                const double x = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
                range.first = std::min(range.first, x);
                range.second = std::max(range.second, x);
            }
        }
        return range;
    }
};

ChartTriangle makeChartTriangle(const Surface& surface, std::uint32_t triangle,
                                const MapStack& stack) {
    ChartTriangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = surface.indices[std::size_t{triangle} * 3 + k];
        corners.p[k] =
            glm::clamp(glm::dvec2(surface.uvs[vertex]), 0.0, 1.0) * glm::dvec2(stack.mapSize) +
            glm::dvec2(0.0, double(surface.map - stack.first) * stack.mapSize.y);
    }
    return corners;
}

} // namespace

// Places are Hammersley's: each row of a texel has one, a fraction of it to the right, so that
// their projections onto both axes are evenly spaced. A border along an axis is off by less than
// 1 / places.
std::vector<float> chartCoverage(const BakeGeometry& geometry, std::span<const PointShape> shapes,
                                 const MapStack& stack, const PointTarget& target, int places) {
    std::vector<float> covered(target.facets.size(), 0.0F);
    const float area = 1.0F / float(places);
    const auto add = [&](std::size_t texel, float share) { covered[texel] += area * share; };
    const auto addTriangle = [&](const ChartTriangle& corners, const PointShape& shape) {
        const auto [low, high] = std::minmax({corners.p[0].y, corners.p[1].y, corners.p[2].y});
        const auto first = static_cast<std::int64_t>(std::ceil(low * places - 0.5));
        const auto last = static_cast<std::int64_t>(std::floor(high * places - 0.5));
        for (std::int64_t row = first; row <= last; ++row) {
            const double y = (double(row) + 0.5) / places;
            const auto [left, right] = corners.across(y);
            const auto place = static_cast<std::uint32_t>(row % places);
            const double shift = double(bitReversed(place)) * 0x1p-32;
            for (double x = std::ceil(left - shift) + shift; x < right; x += 1.0) {
                target.scatter(glm::vec2(x, y), shape, add);
            }
        }
    };
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const int map = surfaces[s].map;
        if (map < stack.first || map >= stack.first + stack.count) {
            continue;
        }
        for (std::uint32_t t = 0; t < surfaces[s].indices.size() / 3; ++t) {
            const PointShape& shape = shapes[geometry.numberOf({s, t})];
            if (shape.facet > 0.0F) {
                addTriangle(makeChartTriangle(surfaces[s], t, stack), shape);
            }
        }
    }
    return covered;
}

} // namespace aolib::bake
