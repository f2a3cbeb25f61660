#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// A small generator of random numbers (PCG32, O'Neill 2014) with one sequence per seed and index,
/// so that results do not depend on which thread does the work.
class RandomSequence {
public:
    RandomSequence(std::uint64_t seed, std::uint64_t index)
        : state_(mixed(mixed(seed) ^ index)), increment_(2 * index + 1) {
        next();
    }

    /// Uniform in [0, 1), 32 random bits.
    double next() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005ULL + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
        const auto rotation = static_cast<std::uint32_t>(old >> 59U);
        const std::uint32_t bits = (shifted >> rotation) | (shifted << ((32U - rotation) & 31U));
        return 0x1p-32 * double(bits);
    }

private:
    /// The finaliser of splitmix64 (Steele, Lea, Flood 2014): neighbouring seeds end up far apart.
    static std::uint64_t mixed(std::uint64_t z) {
        z += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }

    std::uint64_t state_;
    std::uint64_t increment_;
};

/// The unit square to the unit disc, area preserving, squares to rings (Shirley and Chiu 1997).
inline glm::dvec2 concentricDisc(const glm::dvec2& square) {
    const glm::dvec2 p = 2.0 * square - 1.0;
    if (p.x == 0.0 && p.y == 0.0) {
        return {0.0, 0.0};
    }
    constexpr double quarter = std::numbers::pi / 4.0;
    const bool wide = std::abs(p.x) > std::abs(p.y);
    const double radius = wide ? p.x : p.y;
    const double angle = wide ? quarter * (p.y / p.x) : quarter * (2.0 - p.x / p.y);
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A unit vector about +z with density `cos(theta) / pi` per solid angle, from the unit square.
inline glm::dvec3 cosineDirection(const glm::dvec2& square) {
    const glm::dvec2 disc = concentricDisc(square);
    return {disc, std::sqrt(std::max(0.0, 1.0 - glm::dot(disc, disc)))};
}

/// A right-handed orthonormal basis whose third column is the unit `normal` (Duff et al. 2017).
inline glm::dmat3 basisAbout(const glm::dvec3& normal) {
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    return {{1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
            {b, sign + normal.y * normal.y * a, -normal.y},
            normal};
}

} // namespace aolib
