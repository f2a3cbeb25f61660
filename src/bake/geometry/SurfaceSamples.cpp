#include "bake/geometry/SurfaceSamples.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// A single triangle gets at most so many samples.
constexpr double mostSamples = 4096.0;

/// Steps of Roberts' two-dimensional sequence (2018), the plastic number's inverse powers.
constexpr double step1 = 0.7548776662466927;
constexpr double step2 = 0.5698402909980532;

double computeArea(const Surface& surface, std::uint32_t triangle) {
    const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
    const glm::dvec3 a(surface.positions[index[0]]);
    return 0.5 * glm::length(glm::cross(glm::dvec3(surface.positions[index[1]]) - a,
                                        glm::dvec3(surface.positions[index[2]]) - a));
}

template <typename Visit>
void eachTriangle(const BakeGeometry& geometry, const Visit& visit) {
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const auto triangles = static_cast<std::uint32_t>(surfaces[s].indices.size() / 3);
        for (std::uint32_t t = 0; surfaces[s].map >= 0 && t < triangles; ++t) {
            const double area = computeArea(surfaces[s], t);
            if (area > 0.0) {
                visit(TriangleName{s, t}, area);
            }
        }
    }
}

} // namespace

std::vector<SurfaceSample> triangleCentres(const BakeGeometry& geometry) {
    std::vector<SurfaceSample> samples;
    eachTriangle(geometry, [&](const TriangleName& name, double area) {
        samples.push_back({name, 1.0F / 3.0F, 1.0F / 3.0F, static_cast<float>(area)});
    });
    return samples;
}

std::vector<SurfaceSample> edgeMiddles(const BakeGeometry& geometry) {
    std::vector<SurfaceSample> samples;
    eachTriangle(geometry, [&](const TriangleName& name, double area) {
        const auto third = static_cast<float>(area / 3.0);
        samples.push_back({name, 0.5F, 0.0F, third});
        samples.push_back({name, 0.5F, 0.5F, third});
        samples.push_back({name, 0.0F, 0.5F, third});
    });
    return samples;
}

std::vector<SurfaceSample> spreadSamples(const BakeGeometry& geometry, double density) {
    double total = 0.0;
    std::size_t triangles = 0;
    eachTriangle(geometry, [&](const TriangleName&, double area) {
        total += area;
        ++triangles;
    });
    std::vector<SurfaceSample> samples;
    double x = 0.5;
    double y = 0.5;
    eachTriangle(geometry, [&](const TriangleName& name, double area) {
        const double wanted = density * static_cast<double>(triangles) * area / total;
        const double count = std::clamp(std::round(wanted), 1.0, mostSamples);
        for (int i = 0; i < static_cast<int>(count); ++i) {
            x += step1 - (x + step1 >= 1.0 ? 1.0 : 0.0);
            y += step2 - (y + step2 >= 1.0 ? 1.0 : 0.0);
            const bool beyond = x + y > 1.0; // the unit square's other half is mirrored in
            samples.push_back({name, static_cast<float>(beyond ? 1.0 - x : x),
                               static_cast<float>(beyond ? 1.0 - y : y),
                               static_cast<float>(area / count)});
        }
    });
    return samples;
}

} // namespace aolib::bake
