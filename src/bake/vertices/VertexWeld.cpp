#include "bake/vertices/VertexWeld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// Position and normal, bit by bit; zeros of either sign are one.
struct Key {
    std::array<std::uint32_t, 6> bits;

    Key(const glm::vec3& p, const glm::vec3& n)
        : bits{of(p.x), of(p.y), of(p.z), of(n.x), of(n.y), of(n.z)} {}
    bool operator==(const Key&) const = default;

private:
    static std::uint32_t of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0F); }
};

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
        for (const std::uint32_t bits : key.bits) {
            hash = (hash ^ bits) * 0xbf58476d1ce4e5b9ULL;
            hash ^= hash >> 29U;
        }
        return static_cast<std::size_t>(hash);
    }
};

glm::dvec3 areaVector(const Surface& surface, std::size_t first) {
    const glm::dvec3 a(surface.positions[surface.indices[first]]);
    return glm::cross(glm::dvec3(surface.positions[surface.indices[first + 1]]) - a,
                      glm::dvec3(surface.positions[surface.indices[first + 2]]) - a);
}

/// The place of a corner, moved a little towards its triangle's centre.
glm::dvec3 placeNear(const Surface& surface, std::size_t corner) {
    constexpr double towardsCentre = 0.01;
    const std::size_t first = corner - corner % 3;
    glm::dvec3 centre(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
        centre += glm::dvec3(surface.positions[surface.indices[first + k]]) / 3.0;
    }
    return glm::mix(glm::dvec3(surface.positions[surface.indices[corner]]), centre, towardsCentre);
}

} // namespace

VertexWeld weldVertices(const BakeGeometry& geometry) {
    VertexWeld weld;
    std::unordered_map<Key, std::uint32_t, KeyHash> known;
    std::vector<glm::dvec3> areas;
    std::vector<double> largest; // squared area of the triangle that the point lies on
    for (const Surface& surface : geometry.scene().surfaces) {
        std::vector<std::uint32_t>& numbers = weld.number.emplace_back();
        if (surface.map < 0) {
            continue;
        }
        numbers.assign(surface.positions.size(), VertexWeld::unused);
        for (std::size_t i = 0; i < surface.indices.size(); ++i) {
            const std::uint32_t vertex = surface.indices[i];
            const glm::dvec3 area = areaVector(surface, i - i % 3);
            if (area == glm::dvec3(0.0)) {
                continue;
            }
            if (numbers[vertex] == VertexWeld::unused) {
                const glm::dvec3 normal = surface.normals.empty()
                                              ? glm::dvec3(0.0)
                                              : unitOrZero(glm::dvec3(surface.normals[vertex]));
                const auto [found, fresh] =
                    known.try_emplace(Key(surface.positions[vertex], glm::vec3(normal)),
                                      static_cast<std::uint32_t>(weld.points.size()));
                numbers[vertex] = found->second;
                if (fresh) {
                    weld.points.push_back({glm::dvec3(surface.positions[vertex]), normal, {}});
                    areas.emplace_back(0.0);
                    largest.push_back(0.0);
                }
            }
            const std::uint32_t number = numbers[vertex];
            areas[number] += area;
            if (const double size = glm::dot(area, area); size > largest[number]) {
                largest[number] = size;
                weld.points[number].position = placeNear(surface, i);
                weld.points[number].plane = glm::normalize(area);
            }
        }
    }
    for (std::size_t i = 0; i < weld.points.size(); ++i) {
        SurfacePoint& point = weld.points[i];
        if (point.normal == glm::dvec3(0.0)) {
            point.normal = unitOrZero(areas[i]);
        }
        if (point.normal == glm::dvec3(0.0)) {
            point.normal = geometry.up(); // triangles back to back
        }
        point.plane = glm::dot(point.plane, point.normal) < 0.0 ? -point.plane : point.plane;
    }
    return weld;
}

std::vector<BakedVertices> unweldedVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                            const std::vector<glm::vec4>& values,
                                            const std::vector<OpenSectors>& sectors) {
    OpenSectors open;
    open.fill(1.0F);
    std::vector<BakedVertices> result;
    for (const std::vector<std::uint32_t>& numbers : weld.number) {
        BakedVertices& vertices = result.emplace_back();
        for (const std::uint32_t number : numbers) {
            const bool used = number != VertexWeld::unused;
            const glm::vec4 value = used ? values[number] : glm::vec4(1.0F, 0.0F, 0.0F, 0.0F);
            const glm::vec3 direction(value.y, value.z, value.w);
            const float length = glm::length(direction);
            const glm::dvec3 normal = used ? weld.points[number].normal : geometry.up();
            vertices.visibility.push_back(std::clamp(value.x, 0.0F, 1.0F));
            vertices.bentNormal.push_back(length > 0.0F ? direction / length : glm::vec3(normal));
            if (!sectors.empty()) {
                vertices.sectors.push_back(used ? sectors[number] : open);
            }
        }
    }
    return result;
}

} // namespace aolib::bake
