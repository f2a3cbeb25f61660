#include <aolib/bake/UvReport.h>

#include <array>
#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>

#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

namespace {

/// Shares of triangles and of texels below which a map is as good as without the fault.
constexpr double fewTriangles = 1e-3;
constexpr double fewTexels = 1e-3;

bool hasArea(const Surface& surface, std::uint32_t triangle) {
    const std::uint32_t* index = &surface.indices[std::size_t{triangle} * 3];
    const glm::dvec3 a(surface.positions[index[0]]);
    return glm::cross(glm::dvec3(surface.positions[index[1]]) - a,
                      glm::dvec3(surface.positions[index[2]]) - a) != glm::dvec3(0.0);
}

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g%%", 100.0 * share);
    return text.data();
}

} // namespace

bool UvReport::good() const {
    return triangles > 0 && coveredTexels > 0 &&
           double(unusable()) <= fewTriangles * double(triangles) && overlap() <= fewTexels;
}

std::string UvReport::sentence() const {
    std::string faults;
    const auto count = [&](std::size_t number, const char* what) {
        if (number > 0) {
            faults += (faults.empty() ? "" : ", ") + std::to_string(number) + " " + what;
        }
    };
    count(missing, "have no UVs");
    count(notFinite, "have UVs that are not finite");
    count(outside, "have UVs outside [0,1]");
    count(collapsed, "have no area in the map");
    std::string text = "of " + std::to_string(triangles) + " triangles " +
                       (faults.empty() ? "all have usable UVs" : faults) + "; ";
    if (coveredTexels == 0) {
        return text + "no texel is covered";
    }
    return text + std::to_string(coveredTexels) + " texels are covered, " + percent(overlap()) +
           " of them by more than one place of the surface";
}

UvReport checkUvs(const BakeScene& scene, int map, int width, int height) {
    UvReport report;
    const glm::dvec2 size(width, height);
    for (const Surface& surface : scene.surfaces) {
        if (surface.map != map) {
            continue;
        }
        const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
        report.triangles += triangles;
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const UvFault fault = uvFault(surface, t, size);
            report.missing += fault == UvFault::Missing ? 1 : 0;
            report.notFinite += fault == UvFault::NotFinite ? 1 : 0;
            report.outside += fault == UvFault::Outside ? 1 : 0;
            report.collapsed += fault == UvFault::Collapsed && hasArea(surface, t) ? 1 : 0;
        }
    }
    const TexelRaster raster(scene, map, width, height);
    report.coveredTexels = raster.coveredTexels();
    report.overlappingTexels = raster.overlappingTexels();
    return report;
}

} // namespace aolib::bake
