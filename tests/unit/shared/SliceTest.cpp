// The slice integral and the sector mask that shaders run, run on the CPU.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "shared/sector_mask.h"
#include "shared/slice.h"

namespace aolib::shared {
namespace {

TEST(SliceTest, IntegralIsTheAntiderivative) {
    for (const double gamma : {-1.2, -0.3, 0.0, 0.7, 1.5}) {
        for (const double end : {-2.5, -1.0, 0.4, 1.3, 3.0}) {
            constexpr int kSteps = 20000;
            double sum = 0.0;
            for (int i = 0; i < kSteps; ++i) {
                const double theta = end * (i + 0.5) / kSteps;
                sum += std::cos(theta - gamma) * std::abs(std::sin(theta)) * end / kSteps;
            }
            EXPECT_NEAR(sliceIntegral(float(end), float(gamma)), sum, 2e-6)
                << "gamma " << gamma << " end " << end;
        }
    }
}

TEST(SliceTest, IntegralGoesOnBeyondAHalfTurn) {
    for (const double gamma : {-2.2, -0.3, 1.9}) {
        for (const double end : {-5.5, -3.3, -1.0, 1.3, 4.0, 6.0}) {
            constexpr int kSteps = 20000;
            double sum = 0.0;
            for (int i = 0; i < kSteps; ++i) {
                const double theta = end * (i + 0.5) / kSteps;
                sum += std::cos(theta - gamma) * std::abs(std::sin(theta)) * end / kSteps;
            }
            EXPECT_NEAR(sliceIntegralBeyond(float(end), float(gamma)), sum, 4e-6)
                << "gamma " << gamma << " end " << end;
        }
    }
}

TEST(SliceTest, SlicesAddUpToTheHemisphere) {
    // Over half a turn of slices the cosine-weighted hemisphere is pi, whatever the viewing angle.
    for (const float tilt : {0.0F, 0.5F, 1.2F}) {
        const vec3 v(0, 0, 1);
        const vec3 n(std::sin(tilt), 0, std::cos(tilt));
        constexpr int kSlices = 1000;
        double sum = 0.0;
        for (int i = 0; i < kSlices; ++i) {
            const double phi = std::numbers::pi * (i + 0.5) / kSlices;
            const vec3 t{float(std::cos(phi)), float(std::sin(phi)), 0.0F};
            const vec3 across = cross(v, t);
            const vec3 projected = n - dot(n, across) * across;
            const float gamma = std::atan2(dot(projected, t), dot(projected, v));
            const float half = float(std::numbers::pi / 2);
            sum += double(length(projected)) *
                   double(sliceIntegral(gamma + half, gamma) - sliceIntegral(gamma - half, gamma)) *
                   std::numbers::pi / kSlices;
        }
        EXPECT_NEAR(sum, std::numbers::pi, 1e-4) << "tilt " << tilt;
    }
}

TEST(SectorMaskTest, SectorsCountWhenTheirMiddleIsCovered) {
    EXPECT_EQ(sectorsBetween(0.0F, 1.0F), uvec2(0xFFFFFFFFU, 0xFFFFFFFFU));
    EXPECT_EQ(sectorsBetween(0.0F, 0.5F), uvec2(0xFFFFFFFFU, 0U));
    EXPECT_EQ(sectorsBetween(0.5F, 1.0F), uvec2(0U, 0xFFFFFFFFU));
    EXPECT_EQ(sectorsBetween(0.3F, 0.3F), uvec2(0U, 0U));
    EXPECT_EQ(sectorsBetween(1.0F / 64, 3.0F / 64), uvec2(6U, 0U));
    EXPECT_EQ(sectorsBetween(0.4F / 64, 1.6F / 64), uvec2(3U, 0U));
    EXPECT_EQ(sectorsBetween(0.6F / 64, 1.4F / 64), uvec2(0U, 0U));
    EXPECT_EQ(sectorsBetween(31.0F / 64, 33.0F / 64), uvec2(0x80000000U, 1U));
}

TEST(SectorMaskTest, SharesAreThoseOfTheBits) {
    EXPECT_EQ(shareSet(uvec2(0U, 0U)), 0.0F);
    EXPECT_EQ(shareSet(uvec2(0xFFFFFFFFU, 0xFFFFFFFFU)), 1.0F);
    EXPECT_EQ(shareSet(uvec2(0x80000001U, 0x00010000U)), 3.0F / 64);
    for (int a = 0; a <= 64; a += 7) {
        for (int b = a; b <= 64; b += 5) {
            EXPECT_EQ(shareSet(sectorsBetween(float(a) / 64, float(b) / 64)), float(b - a) / 64);
        }
    }
}

} // namespace
} // namespace aolib::shared
