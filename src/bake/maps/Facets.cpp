#include "bake/maps/Facets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// Of 45 degrees.
constexpr float creaseCosine = 0.7071F;

/// Whole numbers up to this are exact as floats; beyond it facets share numbers.
constexpr std::uint32_t mostNumbers = 1U << 24U;

/// Which vertices hang together.
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) {
            parent_[i] = parent_[parent_[i]];
            i = parent_[i];
        }
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// Position and UV, bit by bit.
using Place = std::array<float, 5>;

struct PlaceHash {
    std::size_t operator()(const Place& place) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
        for (const float value : place) {
            hash = (hash ^ std::bit_cast<std::uint32_t>(value + 0.0F)) * 0xbf58476d1ce4e5b9ULL;
            hash ^= hash >> 29U;
        }
        return static_cast<std::size_t>(hash);
    }
};

bool smooth(const Surface& surface, std::uint32_t a, std::uint32_t b) {
    if (surface.normals.empty()) {
        return true;
    }
    const glm::vec3& m = surface.normals[a];
    const glm::vec3& n = surface.normals[b];
    return glm::dot(m, n) >= creaseCosine * glm::length(m) * glm::length(n);
}

/// Joins vertices at one place, in space and in the map, that face alike.
void joinPlaces(const Surface& surface, Groups& groups) {
    std::unordered_map<Place, std::vector<std::uint32_t>, PlaceHash> known;
    known.reserve(surface.positions.size());
    for (std::uint32_t i = 0; i < surface.positions.size(); ++i) {
        const glm::vec3& p = surface.positions[i];
        const glm::vec2& uv = surface.uvs[i];
        std::vector<std::uint32_t>& there = known[{p.x, p.y, p.z, uv.x, uv.y}];
        const auto like = std::find_if(there.begin(), there.end(), [&](std::uint32_t other) {
            return smooth(surface, i, other);
        });
        if (like != there.end()) {
            groups.join(i, *like);
        } else {
            there.push_back(i);
        }
    }
}

} // namespace

Facets::Facets(const BakeScene& scene) {
    std::uint32_t next = 0;
    for (const Surface& surface : scene.surfaces) {
        std::vector<float>& numbers = number_.emplace_back(surface.positions.size(), 0.0F);
        if (surface.map < 0 || surface.uvs.empty()) {
            continue;
        }
        Groups groups(surface.positions.size());
        for (std::size_t i = 0; i < surface.indices.size(); ++i) {
            groups.join(surface.indices[i - i % 3], surface.indices[i]);
        }
        joinPlaces(surface, groups);
        for (std::uint32_t i = 0; i < numbers.size(); ++i) {
            // A group's first vertex comes before the others.
            const std::uint32_t first = groups.find(i);
            numbers[i] =
                first == i ? static_cast<float>(1 + next++ % (mostNumbers - 1)) : numbers[first];
        }
    }
}

std::vector<float> Facets::ofTexels(const BakeScene& scene, const TexelRaster& raster) const {
    std::vector<float> numbers(raster.size(), 0.0F);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (raster.kind(i) != TexelKind::Empty) {
            numbers[i] = ofTriangle(scene, raster.triangle(i));
        }
    }
    return numbers;
}

} // namespace aolib::bake
