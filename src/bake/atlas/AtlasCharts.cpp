#include "bake/atlas/AtlasCharts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raytracing/CosineSampling.h"

namespace aolib::bake {

namespace {

/// Of 45 degrees: a plane then shows triangles at no less than 0.7 of their size.
constexpr double coneCosine = 0.7071;
/// Turns that are tried for the smallest rectangle about a chart, over a quarter turn.
constexpr int turns = 16;
/// The grid on which a chart is looked at for overlaps: cells per triangle, and the most cells.
constexpr double cellsPerTriangle = 64.0;
constexpr double mostCells = 1048576.0;

constexpr std::uint32_t none = ~0U;

/// Which triangles share an edge, by the places of its ends: vertices split for their normals
/// still hang together. An edge of three or more triangles joins none.
class Neighbours {
public:
    explicit Neighbours(const Surface& surface) {
        const std::vector<std::uint32_t> place = findPlaces(surface);
        std::unordered_map<std::uint64_t, std::array<std::uint32_t, 3>> edges;
        beside_.assign(surface.indices.size(), none);
        for (std::uint32_t corner = 0; corner < surface.indices.size(); ++corner) {
            const std::uint32_t a = place[surface.indices[corner]];
            const std::uint32_t b = place[surface.indices[next(corner)]];
            const std::uint64_t key = (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
            auto& [count, first, second] = edges.try_emplace(key).first->second;
            (count == 0 ? first : second) = corner;
            ++count;
        }
        for (const auto& [key, edge] : edges) {
            const auto& [count, first, second] = edge;
            if (count == 2) {
                beside_[first] = second / 3;
                beside_[second] = first / 3;
            }
        }
    }

    /// The triangle beyond the edge that begins at a corner, or `none`.
    std::uint32_t beside(std::uint32_t corner) const { return beside_[corner]; }

private:
    static std::uint32_t next(std::uint32_t corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    }

    static std::vector<std::uint32_t> findPlaces(const Surface& surface) {
        struct Hash {
            std::size_t operator()(const glm::vec3& p) const {
                std::uint64_t hash = std::bit_cast<std::uint32_t>(p.x + 0.0F);
                hash = hash * 0x9e3779b97f4a7c15ULL ^ std::bit_cast<std::uint32_t>(p.y + 0.0F);
                hash = hash * 0x9e3779b97f4a7c15ULL ^ std::bit_cast<std::uint32_t>(p.z + 0.0F);
                return static_cast<std::size_t>(hash * 0xbf58476d1ce4e5b9ULL >> 16U);
            }
        };
        std::unordered_map<glm::vec3, std::uint32_t, Hash> known;
        std::vector<std::uint32_t> places;
        places.reserve(surface.positions.size());
        for (const glm::vec3& p : surface.positions) {
            places.push_back(
                known.try_emplace(p, static_cast<std::uint32_t>(known.size())).first->second);
        }
        return places;
    }

    std::vector<std::uint32_t> beside_;
};

glm::dvec3 areaVector(const Surface& surface, std::uint32_t triangle) {
    const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
    const glm::dvec3 a(surface.positions[index[0]]);
    return glm::cross(glm::dvec3(surface.positions[index[1]]) - a,
                      glm::dvec3(surface.positions[index[2]]) - a);
}

float cross(const glm::vec2& a, const glm::vec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Turns the chart to where its rectangle is smallest and lies flat, and moves it to (0, 0).
void settle(AtlasChart& chart) {
    glm::vec2 best(1.0F, 0.0F);
    float least = std::numeric_limits<float>::infinity();
    const auto boundsAt = [&](const glm::vec2& axis) {
        glm::vec2 low(std::numeric_limits<float>::infinity());
        glm::vec2 high(-std::numeric_limits<float>::infinity());
        for (const glm::vec2& p : chart.corners) {
            const glm::vec2 turned(glm::dot(p, axis), cross(axis, p));
            low = glm::min(low, turned);
            high = glm::max(high, turned);
        }
        return std::pair(low, high);
    };
    for (int i = 0; i < turns; ++i) {
        const float angle = std::numbers::pi_v<float> / 2.0F * float(i) / float(turns);
        const glm::vec2 axis(std::cos(angle), std::sin(angle));
        const auto [low, high] = boundsAt(axis);
        if (const float area = (high.x - low.x) * (high.y - low.y); area < least) {
            least = area;
            best = axis;
        }
    }
    if (const auto [low, high] = boundsAt(best); high.y - low.y > high.x - low.x) {
        best = {-best.y, best.x};
    }
    const auto [low, high] = boundsAt(best);
    for (glm::vec2& p : chart.corners) {
        p = glm::vec2(glm::dot(p, best), cross(best, p)) - low;
    }
    chart.size = high - low;
}

/// Lays triangles onto the plane that faces `normal`.
AtlasChart laidOut(const Surface& surface, std::size_t number, std::vector<std::uint32_t> triangles,
                   const glm::dvec3& normal) {
    AtlasChart chart;
    chart.surface = number;
    chart.triangles = std::move(triangles);
    const glm::dmat3 basis = basisAbout(normal);
    const glm::dvec3 origin(surface.positions[surface.indices[chart.triangles[0] * 3]]);
    for (const std::uint32_t t : chart.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 p =
                glm::dvec3(surface.positions[surface.indices[std::size_t{t} * 3 + k]]) - origin;
            chart.corners.emplace_back(glm::dot(p, basis[0]), glm::dot(p, basis[1]));
        }
        const glm::vec2* c = &chart.corners[chart.corners.size() - 3];
        chart.area += 0.5F * std::abs(cross(c[1] - c[0], c[2] - c[0]));
    }
    settle(chart);
    return chart;
}

/// Whether two triangles of a chart share a place, seen on a grid.
bool coversItself(const AtlasChart& chart) {
    if (chart.triangles.size() < 2) {
        return false;
    }
    const double cells =
        std::min(mostCells, cellsPerTriangle * static_cast<double>(chart.triangles.size()));
    const double side = std::sqrt(double{chart.size.x} * double{chart.size.y} / cells);
    if (!(side > 0.0)) {
        return false;
    }
    const auto width = static_cast<int>(double{chart.size.x} / side) + 1;
    const auto height = static_cast<int>(double{chart.size.y} / side) + 1;
    std::vector<bool> taken(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto cellSide = static_cast<float>(side);
    for (std::size_t t = 0; t < chart.triangles.size(); ++t) {
        const glm::vec2* p = &chart.corners[t * 3];
        const float area = cross(p[1] - p[0], p[2] - p[0]);
        const glm::vec2 low = glm::min(p[0], glm::min(p[1], p[2])) / cellSide;
        const glm::vec2 high = glm::max(p[0], glm::max(p[1], p[2])) / cellSide;
        for (int y = static_cast<int>(low.y); y <= std::min(height - 1, int(high.y)); ++y) {
            for (int x = static_cast<int>(low.x); x <= std::min(width - 1, int(high.x)); ++x) {
                const glm::vec2 at = (glm::vec2(x, y) + 0.5F) * cellSide;
                const float u = cross(at - p[0], p[2] - p[0]) / area;
                const float v = cross(p[1] - p[0], at - p[0]) / area;
                constexpr float margin = 1e-3F;
                if (u < margin || v < margin || u + v > 1.0F - margin) {
                    continue;
                }
                const auto cell = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x);
                if (taken[cell]) {
                    return true;
                }
                taken[cell] = true;
            }
        }
    }
    return false;
}

} // namespace

std::vector<AtlasChart> cutCharts(const Surface& surface, std::size_t number) {
    const Neighbours neighbours(surface);
    const auto count = static_cast<std::uint32_t>(surface.indices.size() / 3);
    std::vector<glm::dvec3> normals(count);
    std::vector<bool> left(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        const glm::dvec3 area = areaVector(surface, t);
        left[t] = area != glm::dvec3(0.0);
        normals[t] = left[t] ? glm::normalize(area) : area;
    }
    std::vector<AtlasChart> charts;
    for (std::uint32_t seed = 0; seed < count; ++seed) {
        if (!left[seed]) {
            continue;
        }
        std::vector<std::uint32_t> taken{seed};
        left[seed] = false;
        for (std::size_t i = 0; i < taken.size(); ++i) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t other = neighbours.beside(taken[i] * 3 + k);
                if (other != none && left[other] &&
                    glm::dot(normals[other], normals[seed]) > coneCosine) {
                    left[other] = false;
                    taken.push_back(other);
                }
            }
        }
        AtlasChart chart = laidOut(surface, number, std::move(taken), normals[seed]);
        if (!coversItself(chart)) {
            charts.push_back(std::move(chart));
            continue;
        }
        for (const std::uint32_t t : chart.triangles) {
            charts.push_back(laidOut(surface, number, {t}, normals[t]));
        }
    }
    return charts;
}

} // namespace aolib::bake
