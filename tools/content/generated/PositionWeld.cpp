#include "content/generated/PositionWeld.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace aolib {
namespace {

constexpr float cellsPerDistance = 16.0F; ///< most points then need one cell, not eight

std::uint64_t cellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
    std::uint64_t key = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U;
    key = (key ^ static_cast<std::uint64_t>(y)) * 0xC2B2AE3D27D4EB4FU;
    return (key ^ static_cast<std::uint64_t>(z)) * 0x165667B19E3779F9U;
}

} // namespace

void weldPositions(std::vector<glm::vec3>& positions, float distance) {
    const float cell = distance * cellsPerDistance;
    std::unordered_multimap<std::uint64_t, std::size_t> kept;
    kept.reserve(positions.size());
    const auto coordinate = [&](float value) {
        return static_cast<std::int64_t>(std::floor(static_cast<double>(value) / cell));
    };
    for (std::size_t i = 0; i < positions.size(); ++i) {
        glm::vec3& p = positions[i];
        bool found = false;
        const glm::vec3 low = p - distance;
        const glm::vec3 high = p + distance;
        for (std::int64_t x = coordinate(low.x); x <= coordinate(high.x); ++x) {
            for (std::int64_t y = coordinate(low.y); y <= coordinate(high.y); ++y) {
                for (std::int64_t z = coordinate(low.z); z <= coordinate(high.z); ++z) {
                    const auto [begin, end] = kept.equal_range(cellKey(x, y, z));
                    for (auto entry = begin; entry != end && !found; ++entry) {
                        if (glm::distance(positions[entry->second], p) <= distance) {
                            p = positions[entry->second];
                            found = true;
                        }
                    }
                }
            }
        }
        if (!found) {
            kept.emplace(cellKey(coordinate(p.x), coordinate(p.y), coordinate(p.z)), i);
        }
    }
}

} // namespace aolib
