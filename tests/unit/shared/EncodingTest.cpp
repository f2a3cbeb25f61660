#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "shared/distance_code.h"
#include "shared/falloff.h"
#include "shared/octahedral.h"
#include "shared/quality.h"

namespace aolib::shared {
namespace {

float throughSixteenBits(float value) {
    return std::round(value * 65535.0F) / 65535.0F;
}

TEST(DistanceCodeTest, ErrorIsRelativeAndTiny) {
    const float nearest = 0.02F;
    const float farthest = 20.0F;
    const float range = std::log2(farthest / nearest);
    // Half a step of the logarithm, and as much again for the rounding of float.
    const float bound = 2.0F * (std::exp2(range / 131068.0F) - 1.0F);
    for (float distance = nearest; distance <= farthest; distance *= 1.01F) {
        const float kept = throughSixteenBits(encodeDistance(distance, nearest, range));
        ASSERT_GT(kept, 0.0F) << "0 is kept for texels that hit nothing";
        ASSERT_NEAR(decodeDistance(kept, nearest, range) / distance, 1.0F, bound);
    }
}

TEST(DistanceCodeTest, WorksAtEveryScale) {
    for (const float scale : {1e-6F, 1.0F, 1e6F}) {
        const float range = std::log2(1e5F);
        const float kept = throughSixteenBits(encodeDistance(777.0F * scale, scale, range));
        EXPECT_NEAR(decodeDistance(kept, scale, range) / (777.0F * scale), 1.0F, 2e-4F);
    }
}

TEST(OctahedralTest, NormalsComeBack) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 100000; ++i) {
        const vec3 n = normalize(vec3(normal(random), normal(random), normal(random)));
        ASSERT_LT(length(decodeNormal(encodeNormal(n)) - n), 1e-6F);
    }
    for (const vec3 n : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0)}) {
        EXPECT_LT(length(decodeNormal(encodeNormal(n)) - n), 1e-6F);
    }
}

TEST(FalloffTest, WeightsAreThoseOfTheDesign) {
    EXPECT_EQ(occluderWeight(0, 0.99F, 1.0F), 1.0F);
    EXPECT_EQ(occluderWeight(0, 1.01F, 1.0F), 0.0F);
    EXPECT_NEAR(occluderWeight(1, 2.0F, 2.0F), std::exp(-1.0F), 1e-6F);
    EXPECT_EQ(occluderWeight(2, 1e9F, 1.0F), 1.0F);
}

TEST(QualityTest, PrefersNearerCentralAndFacing) {
    // At distance d, with the cosines b to the face's axis and c to the surface's normal.
    const auto quality = [](float d, float b, float c) { return logQuality(d * d, d * b, d * c); };
    const float reference = quality(2.0F, 0.8F, 0.7F);
    EXPECT_NEAR(quality(1.0F, 0.8F, 0.7F) - reference, 2.0F, 1e-5F) << "1/d^2";
    EXPECT_NEAR(quality(2.0F, 0.4F, 0.7F) - reference, -3.0F, 1e-5F) << "cos^3 beta";
    EXPECT_NEAR(quality(2.0F, 0.8F, 0.35F) - reference, -1.0F, 1e-5F) << "cos delta";
    EXPECT_NEAR(quality(2e12F, 0.8F, 0.7F) - reference, -2.0F * std::log2(1e12F), 1e-4F);
    EXPECT_NEAR(quality(2e-12F, 0.8F, 0.7F) - reference, 2.0F * std::log2(1e12F), 1e-4F);
}

} // namespace
} // namespace aolib::shared
