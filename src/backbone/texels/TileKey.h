#pragma once

#include <cstdint>

namespace aolib {

/// What a request to trace texels is known by: cube map, whether it is of detail, and tile.
struct TileKey {
    static constexpr unsigned kTileBits = 23;

    std::uint32_t cubeMap;
    bool detail;
    int tile;

    std::uint64_t packed() const {
        return ((std::uint64_t{cubeMap} * 2U + (detail ? 1U : 0U)) << kTileBits) |
               static_cast<std::uint64_t>(tile);
    }
    static TileKey unpacked(std::uint64_t key) {
        const std::uint64_t top = key >> kTileBits;
        return {static_cast<std::uint32_t>(top / 2U), top % 2U == 1U,
                static_cast<int>(key & ((1ULL << kTileBits) - 1ULL))};
    }
};

} // namespace aolib
