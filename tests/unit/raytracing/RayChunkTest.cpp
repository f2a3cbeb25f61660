#include "raytracing/RayChunk.h"

#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(RayChunk, DirectionsAreUnitVectorsAboveTheSurface) {
    RayChunk chunk;
    for (int texel = 0; texel < 64; ++texel) {
        chunk.fill(sequenceSeed(0, texel, 3), 64U * static_cast<unsigned>(texel), 64);
        for (std::size_t i = 0; i < 64; ++i) {
            EXPECT_NEAR(std::hypot(chunk.x[i], chunk.y[i], chunk.z[i]), 1.0F, 1e-6F);
            EXPECT_GT(chunk.z[i], 0.0F);
        }
    }
}

TEST(RayChunk, EveryRayHasACellOfItsOwn) {
    RayChunk chunk;
    for (int count = 1; count <= RayChunk::capacity; count *= 2) {
        for (int texel = 0; texel < 16; ++texel) {
            const auto start = static_cast<std::uint32_t>(count * texel);
            chunk.fill(sequenceSeed(5, texel, 1), start, count);
            const std::set<std::uint32_t> cells(chunk.cell.begin(), chunk.cell.begin() + count);
            EXPECT_EQ(cells.size(), static_cast<std::size_t>(count));
            EXPECT_LT(*cells.rbegin(), static_cast<std::uint32_t>(count));
        }
    }
}

/// The cells of two texels are the same parts of the hemisphere.
TEST(RayChunk, RaysOfEqualCellsPointAlike) {
    RayChunk one;
    RayChunk other;
    one.fill(sequenceSeed(0, 1, 2), 0, 64);
    other.fill(sequenceSeed(4, 7, 9), 128, 64);
    for (std::size_t i = 0; i < 64; ++i) {
        for (std::size_t j = 0; j < 64; ++j) {
            if (one.cell[i] == other.cell[j]) {
                EXPECT_LT(std::hypot(one.x[i] - other.x[j], one.y[i] - other.y[j]), 0.4F);
            }
        }
    }
}

/// Means over the hemisphere with the cosine's density: of z 2/3, of z^2 1/2, of x^2 1/4.
TEST(RayChunk, MomentsAreThoseOfTheCosine) {
    RayChunk chunk;
    double z = 0.0;
    double zz = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    const int chunks = 256;
    for (std::uint32_t k = 0; k < chunks; ++k) {
        chunk.fill(sequenceSeed(2, 11, 13), 64 * k, 64);
        for (std::size_t i = 0; i < 64; ++i) {
            z += chunk.z[i];
            zz += chunk.z[i] * chunk.z[i];
            xx += chunk.x[i] * chunk.x[i];
            xy += chunk.x[i] * chunk.y[i];
        }
    }
    const double rays = 64.0 * chunks;
    EXPECT_NEAR(z / rays, 2.0 / 3.0, 1e-4);
    EXPECT_NEAR(zz / rays, 0.5, 1e-4);
    EXPECT_NEAR(xx / rays, 0.25, 1e-4);
    EXPECT_NEAR(xy / rays, 0.0, 1e-4);
}

/// A wall's edge: the share of rays that lean further than 0.3 to one side. Random rays have an
/// error of sqrt(p (1 - p) / n); these have less than a third of it at 64 and a fifth at 256.
TEST(RayChunk, ErrorFallsFasterThanThatOfRandomRays) {
    const double side = 0.3;
    const double p = (std::acos(side) - side * std::sqrt(1.0 - side * side)) / std::numbers::pi;
    for (const int rays : {64, 256}) {
        double squares = 0.0;
        const int texels = 512;
        for (int texel = 0; texel < texels; ++texel) {
            RayChunk chunk;
            int beyond = 0;
            for (int start = 0; start < rays; start += 64) {
                chunk.fill(sequenceSeed(0, texel, 0), static_cast<std::uint32_t>(start), 64);
                for (std::size_t i = 0; i < 64; ++i) {
                    beyond += double{chunk.x[i]} > side ? 1 : 0;
                }
            }
            const double error = double(beyond) / rays - p;
            squares += error * error;
        }
        const double random = std::sqrt(p * (1.0 - p) / rays);
        EXPECT_LT(std::sqrt(squares / texels), random / (rays == 64 ? 3.0 : 5.0)) << rays;
    }
}

} // namespace
} // namespace aolib
