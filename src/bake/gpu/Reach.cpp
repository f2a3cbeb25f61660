#include "bake/gpu/Reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "raytracing/SobolSequence.h"

namespace aolib::bake {

namespace {

/// A slab is at least so thick: of the frame, whose diameter is 2.
constexpr double leastRadius = 2.0 / 512.0;
/// What is nearer than this share of the radius counts in full: by 1/64 too much, at most.
constexpr double leastShare = 1.0 / 64.0;

/// The third dimension of Sobol's sequence, bit-reversed as the first two are: of the polynomial
/// x^2 + x + 1, whose numbers start with 1 and 3.
std::uint32_t sobolThird(std::uint32_t index) {
    std::uint32_t sum = 0;
    std::uint32_t before = 1;
    std::uint32_t number = 1;
    for (unsigned bit = 0; bit < 32U; ++bit) {
        if (((index >> bit) & 1U) != 0) {
            sum ^= number << (31U - bit);
        }
        const std::uint32_t next = bit == 0 ? 3U : (number << 1U) ^ (before << 2U) ^ before;
        before = number;
        number = next;
    }
    return bitReversed(sum);
}

} // namespace

double drawRadius(const Reach& reach, std::uint32_t seed, std::uint32_t index) {
    if (reach.endless()) {
        return std::numeric_limits<double>::infinity();
    }
    if (reach.falloff == Falloff::Step) {
        return reach.radius;
    }
    const SequenceSeed own = sequenceSeed(7, 1, static_cast<int>(seed & 0x7fffffffU));
    const std::uint32_t bits = bitReversed(scrambled(sobolThird(index), own.first));
    const double share = -std::log((double(bits) + 0.5) * 0x1p-32);
    return std::max(reach.radius * std::max(share, leastShare), leastRadius);
}

AoStatus checkReach(const Reach& reach, double scale) {
    if (reach.endless() || reach.radius >= leastRadius) {
        return {};
    }
    return {StatusCode::InvalidOption,
            "radius is " + std::to_string(reach.radius / scale) + ", must be at least " +
                std::to_string(leastRadius / scale) +
                ", a 512th of the scene's diagonal: nearer occluders are for rays"};
}

} // namespace aolib::bake
