#pragma once

#include <cstdint>

namespace aolib {

/// What a request to trace texels is known by: cube map, whether it is of detail, tile and
/// generation.
struct TileKey {
    static constexpr unsigned kTileBits = 23;
    static constexpr unsigned kGenerationBits = 16;

    std::uint32_t cubeMap;
    bool detail;
    int tile;
    std::uint32_t generation;

    std::uint64_t packed() const {
        return ((std::uint64_t{cubeMap} * 2U + (detail ? 1U : 0U))
                << (kTileBits + kGenerationBits)) |
               (static_cast<std::uint64_t>(tile) << kGenerationBits) | generation;
    }
    static TileKey unpacked(std::uint64_t key) {
        const std::uint64_t top = key >> (kTileBits + kGenerationBits);
        return {static_cast<std::uint32_t>(top / 2U), top % 2U == 1U,
                static_cast<int>((key >> kGenerationBits) & ((1ULL << kTileBits) - 1ULL)),
                static_cast<std::uint32_t>(key & ((1ULL << kGenerationBits) - 1ULL))};
    }
};

} // namespace aolib
