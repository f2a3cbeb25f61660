#pragma once

#include <cstdint>

namespace aolib {

/// The first two dimensions of Sobol's sequence, scrambled after Owen by hashes (Burley 2020,
/// "Practical Hash-based Owen Scrambling"): any 2^k points that start at a multiple of 2^k have one
/// point in each of the 2^k equal cells into which halvings of the square's sides can cut it.
///
/// All numbers here are bit-reversed: the lowest bit says which half of the unit interval it is.

/// What the points of one texel are scrambled with.
struct SequenceSeed {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

/// Far apart for neighbouring texels: the finaliser of splitmix64 (Steele, Lea, Flood 2014).
constexpr SequenceSeed sequenceSeed(int face, int x, int y) {
    std::uint64_t z = (static_cast<std::uint64_t>(face) << 40U) ^
                      (static_cast<std::uint64_t>(y) << 20U) ^ static_cast<std::uint64_t>(x);
    z += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    z ^= z >> 31U;
    return {static_cast<std::uint32_t>(z), static_cast<std::uint32_t>(z >> 32U)};
}

/// In an order of steps in which no compiler finds a swap of bytes, which old vector units lack.
constexpr std::uint32_t bitReversed(std::uint32_t v) {
    v = ((v & 0x00ff00ffU) << 8U) | ((v & 0xff00ff00U) >> 8U);
    v = ((v & 0x0f0f0f0fU) << 4U) | ((v & 0xf0f0f0f0U) >> 4U);
    v = ((v & 0x33333333U) << 2U) | ((v & 0xccccccccU) >> 2U);
    v = ((v & 0x55555555U) << 1U) | ((v & 0xaaaaaaaaU) >> 1U);
    return (v << 16U) | (v >> 16U);
}

/// The second dimension; the first is the index itself (van der Corput). Its matrix is Pascal's
/// triangle modulo 2, so it is linear: `s(a ^ b) = s(a) ^ s(b)`.
constexpr std::uint32_t sobolSecond(std::uint32_t index) {
    std::uint32_t sum = 0;
    for (std::uint32_t column = 1; index != 0; index >>= 1U, column ^= column << 1U) {
        sum ^= (index & 1U) != 0 ? column : 0U;
    }
    return sum;
}

/// Owen's scrambling: each bit is flipped or not by a hash of the lower ones (Laine and Karras
/// 2011, with the constants of Vegdahl 2021).
constexpr std::uint32_t scrambled(std::uint32_t v, std::uint32_t seed) {
    v ^= v * 0x3d20adeaU;
    v += seed;
    v *= (seed >> 16U) | 1U;
    v ^= v * 0x05526c56U;
    return v ^ (v * 0x53a22864U);
}

} // namespace aolib
