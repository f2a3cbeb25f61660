#include "bake/scatter/VertexSums.h"

#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace aolib::bake {

VertexSums::VertexSums(const BakeGeometry& geometry, const BakeFrame& frame, const VertexWeld& weld,
                       const glm::vec4& ground)
    : weights_(geometry, frame, PointWeights::Settings{{1, 1}, 1.0F, ground, true}),
      triangles_(geometry.triangleCount()), light_(weld.points.size(), glm::dvec4(0.0)),
      areas_(weld.points.size(), 0.0) {
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const auto count = static_cast<std::uint32_t>(surfaces[s].indices.size() / 3);
        for (std::uint32_t t = 0; surfaces[s].map >= 0 && t < count; ++t) {
            addTriangle(surfaces[s], {s, t}, frame, weld, triangles_[geometry.numberOf({s, t})]);
        }
    }
}

void VertexSums::addTriangle(const Surface& surface, const TriangleName& name,
                             const BakeFrame& frame, const VertexWeld& weld, Triangle& triangle) {
    std::array<glm::dvec3, 3> p;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = surface.indices[std::size_t{name.triangle} * 3 + k];
        p[k] = glm::dvec3(frame.toFrame(glm::dvec3(surface.positions[vertex])));
        corners[k] = weld.number[name.surface][vertex];
        if (corners[k] == VertexWeld::unused) {
            return;
        }
    }
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double square = glm::dot(normal, normal);
    if (!(square > 0.0)) {
        return;
    }
    // A corner's weight grows from 0 on the edge across from it, at right angles to that.
    triangle.origin = glm::vec3(p[0]);
    triangle.alongSecond = glm::vec3(glm::cross(p[2] - p[0], normal) / square);
    triangle.alongThird = glm::vec3(glm::cross(normal, p[1] - p[0]) / square);
    triangle.corners = corners;
    for (const std::uint32_t corner : corners) {
        areas_[corner] += 0.5 * glm::sqrt(square) / 3.0;
    }
}

void VertexSums::add(const std::vector<glm::vec4>& picture, const LightView& view) {
    const glm::dvec4 unit(1.0, view.direction);
    for (const glm::vec4& pixel : picture) {
        if (pixel.w == 0.0F) {
            continue;
        }
        const auto number = static_cast<std::size_t>(pixel.w) - 1;
        const Triangle& triangle = triangles_[number];
        if (triangle.corners[0] == VertexWeld::unused) {
            continue;
        }
        const glm::vec3 from = glm::vec3(pixel) - triangle.origin;
        const float second = glm::clamp(glm::dot(triangle.alongSecond, from), 0.0F, 1.0F);
        const float third = glm::clamp(glm::dot(triangle.alongThird, from), 0.0F, 1.0F - second);
        const double weight{weights_.of(number, {second, third}, view)};
        if (weight > 0.0) {
            const std::array<double, 3> shares{1.0 - double{second} - double{third}, double{second},
                                               double{third}};
            for (std::size_t k = 0; k < 3; ++k) {
                light_[triangle.corners[k]] += weight * shares[k] * unit;
            }
        }
    }
}

} // namespace aolib::bake
