#include "bake/scatter/PointWeights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>

#include "bake/maps/TexelRaster.h"
#include "scene/Finite.h"

namespace aolib::bake {

namespace {

// As in shaders/bake/lit_side.glsl and scatter_surface.frag.
constexpr float standsOnGround = 1e-5F;
constexpr float mostGrazing = 20.0F;

} // namespace

PointWeights::PointWeights(const BakeGeometry& geometry, const BakeFrame& frame,
                           const Settings& settings)
    : up_(settings.ground), triangles_(geometry.triangleCount()) {
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Surface& surface = surfaces[s];
        const auto count = static_cast<std::uint32_t>(surface.indices.size() / 3);
        for (std::uint32_t t = 0; surface.map >= 0 && t < count; ++t) {
            if (settings.barycentric ||
                uvFault(surface, t, glm::dvec2(settings.mapSize)) == UvFault::None) {
                triangles_[geometry.numberOf({s, t})] = makeTriangle(surface, t, frame, settings);
            }
        }
    }
}

PointWeights::Triangle PointWeights::makeTriangle(const Surface& surface, std::uint32_t number,
                                                  const BakeFrame& frame,
                                                  const Settings& settings) {
    std::array<glm::dvec3, 3> p;
    std::array<glm::dvec2, 3> uv;
    std::array<glm::dvec3, 3> normals;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = surface.indices[std::size_t{number} * 3 + k];
        p[k] = glm::dvec3(frame.toFrame(glm::dvec3(surface.positions[vertex])));
        uv[k] = settings.barycentric ? glm::dvec2(k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0)
                                     : glm::clamp(glm::dvec2(surface.uvs[vertex]), 0.0, 1.0);
        const bool given = !surface.normals.empty() && isFinite(surface.normals[vertex]);
        normals[k] = given ? glm::dvec3(surface.normals[vertex]) : glm::dvec3(0.0);
    }
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double size = glm::length(area);
    const glm::dvec2 a = uv[1] - uv[0];
    const glm::dvec2 b = uv[2] - uv[0];
    const double determinant = a.x * b.y - a.y * b.x;
    Triangle triangle;
    if (!(size > 0.0) || determinant == 0.0) {
        return triangle;
    }
    // The gradient along u and v of what has values at the corners.
    const auto alongU = [&](const auto& v) {
        return ((v[1] - v[0]) * b.y - (v[2] - v[0]) * a.y) / determinant;
    };
    const auto alongV = [&](const auto& v) {
        return ((v[2] - v[0]) * a.x - (v[1] - v[0]) * b.x) / determinant;
    };
    const auto mean = [](const auto& v) { return (v[0] + v[1] + v[2]) / 3.0; };
    triangle.middle = glm::vec2(mean(uv));
    triangle.normal = glm::vec3(mean(normals));
    triangle.normalAlongU = glm::vec3(alongU(normals));
    triangle.normalAlongV = glm::vec3(alongV(normals));
    triangle.plane = glm::vec3(area / size);
    const glm::dvec3 up(settings.ground);
    const std::array<double, 3> heights{glm::dot(p[0], up) - double{settings.ground.w},
                                        glm::dot(p[1], up) - double{settings.ground.w},
                                        glm::dot(p[2], up) - double{settings.ground.w}};
    triangle.height = glm::vec3(mean(heights), alongU(heights), alongV(heights));
    const double texels = double(settings.mapSize.x) * double(settings.mapSize.y);
    triangle.density = settings.density > 0.0F
                           ? settings.density
                           : static_cast<float>(std::abs(determinant) * texels / size);
    return triangle;
}

float PointWeights::of(std::size_t number, const glm::vec2& uv, const LightView& view) const {
    const Triangle& triangle = triangles_[number];
    const glm::vec3 direction(view.direction);
    const glm::vec2 from = uv - triangle.middle;
    const glm::vec3 normal =
        triangle.normal + from.x * triangle.normalAlongU + from.y * triangle.normalAlongV;
    const float length = glm::length(normal);
    const glm::vec3 unit = length > 0.0F ? normal / length : triangle.plane;
    const float facing = glm::dot(triangle.plane, direction);
    if ((glm::dot(triangle.plane, unit) < 0.0F ? -facing : facing) <= 0.0F) {
        return 0.0F;
    }
    const float rise = glm::dot(direction, up_);
    const float height =
        triangle.height.x + from.x * triangle.height.y + from.y * triangle.height.z;
    const bool towards = height >= -standsOnGround ? rise < 0.0F : rise > 0.0F;
    if (towards && std::abs(height) < static_cast<float>(view.reach) * std::abs(rise)) {
        return 0.0F;
    }
    const float grazing = std::abs(facing);
    const float cosine = std::max(0.0F, glm::dot(unit, direction));
    const auto pixel = static_cast<float>(view.pixel.x * view.pixel.y);
    // A pixel's area on the surface is `pixel / grazing`.
    return triangle.density * pixel * std::min(cosine / grazing, mostGrazing);
}

} // namespace aolib::bake
