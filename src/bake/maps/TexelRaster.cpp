#include "bake/maps/TexelRaster.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// UVs may miss [0,1] by this much, the rounding of what made them.
constexpr double uvTolerance = 1e-4;
/// Less than this many square texels is no area.
constexpr double leastArea = 1e-8;
/// Within this many texels of an edge a centre may count as inside both triangles.
constexpr double edgeWidth = 1e-2;
/// A receiver keeps this far from its triangle's edges, texels. In a crease the edge lies in the
/// other surface, too, and a ray that starts there is closed or open by rounding alone.
constexpr double inset = 0.1;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

bool finite(const glm::vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

bool outside(const glm::vec2& v) {
    const auto beyond = [](float x) {
        return double{x} < -uvTolerance || double{x} > 1.0 + uvTolerance;
    };
    return beyond(v.x) || beyond(v.y);
}

/// Of a segment from `a` along `ab`, the share at which it comes nearest to `p`.
double nearestShare(const glm::dvec2& a, const glm::dvec2& ab, const glm::dvec2& p) {
    const double length = glm::dot(ab, ab);
    return length > 0.0 ? std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0) : 0.0;
}

} // namespace

/// A triangle in the map, texels; its area is not zero.
struct TexelRaster::Corners {
    std::array<glm::dvec2, 3> p;
    double area; ///< twice the signed area

    Corners(const Surface& surface, std::uint32_t triangle, const glm::dvec2& size) {
        const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = glm::clamp(glm::dvec2(surface.uvs[index[i]]), 0.0, 1.0) * size;
        }
        area = cross(p[1] - p[0], p[2] - p[0]);
    }

    glm::dvec2 barycentric(const glm::dvec2& at) const {
        return {cross(at - p[0], p[2] - p[0]) / area, cross(p[1] - p[0], at - p[0]) / area};
    }

    /// How far inside all edges a point with these weights lies, texels; negative outside.
    double depth(const glm::dvec2& b) const {
        const double size = std::abs(area);
        return std::min({b.x * size / glm::distance(p[0], p[2]),
                         b.y * size / glm::distance(p[0], p[1]),
                         (1.0 - b.x - b.y) * size / glm::distance(p[1], p[2])});
    }

    /// Weights of a point at least `inset` inside all edges, or else of the incircle's centre:
    /// those given, of a point `depth` inside, moved towards that centre.
    glm::dvec2 keptInside(const glm::dvec2& weights, double depth) const {
        const glm::dvec3 sides(glm::distance(p[1], p[2]), glm::distance(p[2], p[0]),
                               glm::distance(p[0], p[1]));
        const double perimeter = sides.x + sides.y + sides.z;
        const double radius = std::abs(area) / perimeter;
        if (depth >= inset || !(radius > depth)) {
            return weights;
        }
        const double share = std::min(1.0, (inset - depth) / (radius - depth));
        return glm::mix(weights, glm::dvec2(sides.y, sides.z) / perimeter, share);
    }

    /// The weights of the boundary's point next to `at`, and that point.
    std::pair<glm::dvec2, glm::dvec2> nearest(const glm::dvec2& at) const {
        constexpr std::array<glm::dvec2, 3> weights{glm::dvec2(0.0, 0.0), glm::dvec2(1.0, 0.0),
                                                    glm::dvec2(0.0, 1.0)};
        std::pair<glm::dvec2, glm::dvec2> best;
        double least = INFINITY;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const double share = nearestShare(p[i], p[j] - p[i], at);
            const glm::dvec2 point = glm::mix(p[i], p[j], share);
            const glm::dvec2 offset = point - at;
            if (const double distance = glm::dot(offset, offset); distance < least) {
                least = distance;
                best = {glm::mix(weights[i], weights[j], share), point};
            }
        }
        return best;
    }
};

UvFault uvFault(const Surface& surface, std::uint32_t triangle, const glm::dvec2& size) {
    if (surface.uvs.empty()) {
        return UvFault::Missing;
    }
    const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
    std::array<glm::dvec2, 3> p;
    UvFault fault = UvFault::None;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec2& uv = surface.uvs[index[i]];
        if (!finite(uv)) {
            return UvFault::NotFinite;
        }
        fault = outside(uv) ? UvFault::Outside : fault;
        p[i] = glm::dvec2(uv) * size;
    }
    if (fault == UvFault::None && std::abs(cross(p[1] - p[0], p[2] - p[0])) < leastArea) {
        return UvFault::Collapsed;
    }
    return fault;
}

TexelRaster::TexelRaster(const BakeScene& scene, int map, int width, int height,
                         const glm::dvec2& place)
    : width_(width), height_(height), place_(place) {
    const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    kind_.assign(texels, TexelKind::Empty);
    triangle_.resize(texels);
    barycentric_.resize(texels);
    mark_.assign(texels, 0.0F);
    const glm::dvec2 size(width, height);
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface& surface = scene.surfaces[s];
        const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
        for (std::uint32_t t = 0; surface.map == map && t < triangles; ++t) {
            if (uvFault(surface, t, size) != UvFault::None) {
                continue;
            }
            const Corners corners(surface, t, size);
            if (std::abs(corners.area) > 0.0) {
                add(corners, {s, t});
            }
        }
    }
}

void TexelRaster::add(const Corners& corners, const TriangleName& name) {
    const glm::dvec2 low = glm::min(corners.p[0], glm::min(corners.p[1], corners.p[2]));
    const glm::dvec2 high = glm::max(corners.p[0], glm::max(corners.p[1], corners.p[2]));
    const int left = std::max(0, static_cast<int>(std::floor(low.x)));
    const int right = std::min(width_ - 1, static_cast<int>(std::floor(high.x)));
    const int bottom = std::max(0, static_cast<int>(std::floor(low.y)));
    const int top = std::min(height_ - 1, static_cast<int>(std::floor(high.y)));
    for (int y = bottom; y <= top; ++y) {
        for (int x = left; x <= right; ++x) {
            visit(corners, name, x, y);
        }
    }
}

void TexelRaster::visit(const Corners& corners, const TriangleName& name, int x, int y) {
    const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(x);
    const glm::dvec2 centre = glm::dvec2(x, y) + place_;
    const glm::dvec2 weights = corners.barycentric(centre);
    const double depth = corners.depth(weights);
    if (depth >= 0.0) {
        if (kind_[texel] != TexelKind::Inside) {
            kind_[texel] = TexelKind::Inside;
            triangle_[texel] = name;
            barycentric_[texel] = glm::vec2(corners.keptInside(weights, depth));
            mark_[texel] = 0.0F;
        }
        if (depth > edgeWidth) {
            mark_[texel] += 1.0F;
            overlapping_ += mark_[texel] == 2.0F ? 1 : 0;
        }
        return;
    }
    if (kind_[texel] == TexelKind::Inside) {
        return;
    }
    const auto [nearWeights, point] = corners.nearest(centre);
    const glm::dvec2 offset = glm::abs(point - centre);
    const auto distance = static_cast<float>(glm::dot(offset, offset));
    const bool touches = std::max(offset.x, offset.y) <= 0.5;
    if (touches && (kind_[texel] == TexelKind::Empty || distance < mark_[texel])) {
        kind_[texel] = TexelKind::Border;
        triangle_[texel] = name;
        barycentric_[texel] = glm::vec2(corners.keptInside(nearWeights, 0.0));
        mark_[texel] = distance;
    }
}

std::size_t TexelRaster::coveredTexels() const {
    return static_cast<std::size_t>(std::count(kind_.begin(), kind_.end(), TexelKind::Inside));
}

} // namespace aolib::bake
