#pragma once

#include <cstdint>

namespace aolib {

/// The generator PCG-XSH-RR 64/32 (O'Neill 2014): small, and the same numbers on every machine.
class Pcg {
public:
    explicit Pcg(std::uint64_t seed) : state_(seed + increment) { next(); }

    std::uint32_t next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005U + increment;
        const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto turn = static_cast<std::uint32_t>(old >> 59U);
        return (mixed >> turn) | (mixed << ((32U - turn) & 31U));
    }
    /// Uniform in [from, to).
    float uniform(float from, float to) {
        const float unit = static_cast<float>(next() >> 8U) * (1.0F / 16777216.0F);
        return from + (to - from) * unit;
    }
    /// Uniform in 0 ... count - 1.
    int pick(int count) {
        return static_cast<int>(
            (static_cast<std::uint64_t>(next()) * static_cast<std::uint64_t>(count)) >> 32U);
    }

private:
    static constexpr std::uint64_t increment = 1442695040888963407U;
    std::uint64_t state_;
};

} // namespace aolib
