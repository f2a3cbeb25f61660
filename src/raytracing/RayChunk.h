#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "raytracing/SobolSequence.h"

namespace aolib {

/// A stretch of one texel's sequence of rays: directions about +z with the density
/// `cos(theta) / pi` per solid angle. Single precision and free of branches, for vector units.
struct RayChunk {
    static constexpr int capacity = 256; ///< rays, a power of two

    alignas(64) std::array<float, capacity> x;
    alignas(64) std::array<float, capacity> y;
    alignas(64) std::array<float, capacity> z;
    /// Of the equal cells of the hemisphere, as many as there are rays, the one that the ray goes
    /// through. No two rays share one; neighbours in number are mostly neighbours in space.
    alignas(64) std::array<std::uint32_t, capacity> cell;

    /// @param start  the first ray's place in the sequence, a multiple of `count`.
    /// @param count  rays, a power of two up to the capacity.
    void fill(SequenceSeed seed, std::uint32_t start, int count);

    /// Returns the length of the longest chunk of rays `start` to `end` - 1 that begins at `start`:
    /// a power of two that `start` is a multiple of. @param end  above `start`.
    static constexpr std::uint32_t longest(std::uint32_t start, std::uint32_t end) {
        const std::uint32_t alignment = start == 0 ? capacity : start & (~start + 1);
        return std::min({std::uint32_t{capacity}, alignment, std::bit_floor(end - start)});
    }
};

namespace ray_chunk {

static_assert(RayChunk::capacity == 1 << 8, "as mortonCell() numbers cells");

/// `sobolSecond()` of a chunk's own indices; the rest of an index is added by linearity.
inline constexpr auto sobolTable = [] {
    std::array<std::uint32_t, RayChunk::capacity> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        table[i] = sobolSecond(i);
    }
    return table;
}();

/// The four coarsest bits of two bit-reversed coordinates interleaved, coarsest first: the cell of
/// a square of 16 x 16 on Morton's curve.
constexpr std::uint32_t mortonCell(std::uint32_t first, std::uint32_t second) {
    const auto spread = [](std::uint32_t v) {
        return ((v & 1U) << 6U) | ((v & 2U) << 3U) | (v & 4U) | ((v & 8U) >> 3U);
    };
    return (spread(first) << 1U) | spread(second);
}

/// From a bit-reversed coordinate to the middle of one of 2^24 cells of [-1, 1]: never 0.
constexpr float signedUnit(std::uint32_t reversed) {
    const auto odd = static_cast<std::int32_t>((bitReversed(reversed) >> 8U) * 2U + 1U);
    return static_cast<float>(odd - (1 << 24)) * 0x1p-24F;
}

} // namespace ray_chunk

inline void RayChunk::fill(SequenceSeed seed, std::uint32_t start, int count) {
    // Plain pointers: compilers see through them to vector units.
    float* const across = x.data();
    float* const along = y.data();
    float* const upwards = z.data();
    std::uint32_t* const cells = cell.data();
    const std::uint32_t* const table = ray_chunk::sobolTable.data();
    const std::uint32_t second = sobolSecond(start);
    const auto size = static_cast<std::uint32_t>(count);
    const auto drop = static_cast<std::uint32_t>(8 - std::countr_zero(size));
    for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t a = scrambled(start + i, seed.first);
        const std::uint32_t b = scrambled(second ^ table[i], seed.second);
        cells[i] = ray_chunk::mortonCell(a, b) >> drop;
        across[i] = ray_chunk::signedUnit(a);
        along[i] = ray_chunk::signedUnit(b);
    }
    // From the square to the disc and up (Shirley and Chiu 1997). The angle stays within 45 degrees
    // of an axis, where these series are good to 3e-7.
    for (std::uint32_t i = 0; i < size; ++i) {
        const bool wide = std::abs(across[i]) > std::abs(along[i]);
        const float radius = wide ? across[i] : along[i];
        const float other = wide ? along[i] : across[i];
        const float angle = 0.25F * std::numbers::pi_v<float> * (other / radius);
        const float a2 = angle * angle;
        const float sine = angle * (1.0F - a2 / 6.0F * (1.0F - a2 / 20.0F * (1.0F - a2 / 42.0F)));
        const float cosine =
            1.0F - a2 / 2.0F * (1.0F - a2 / 12.0F * (1.0F - a2 / 30.0F * (1.0F - a2 / 56.0F)));
        across[i] = radius * (wide ? cosine : sine);
        along[i] = radius * (wide ? sine : cosine);
        upwards[i] = std::sqrt(1.0F - radius * radius);
    }
}

} // namespace aolib
