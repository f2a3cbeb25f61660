#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <aolib/Options.h>

#include "shared/distance_code.h"
#include "shared/falloff.h"
#include "shared/normal_pair.h"
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
    const vec2 span = distanceSpan(nearest, farthest);
    // Half a step, and a quarter for the rounding of float.
    const float bound = 1.25F * std::log2(farthest / nearest) / 131068.0F;
    for (float distance = nearest; distance <= farthest; distance *= 1.01F) {
        const float kept = throughSixteenBits(encodeDistance(distance, span));
        ASSERT_GT(kept, 0.0F) << "0 is kept for texels that hit nothing";
        ASSERT_NEAR(decodeDistance(kept, span) / distance, 1.0F, bound);
    }
}

TEST(DistanceCodeTest, WorksAtEveryScale) {
    for (const float scale : {1e-6F, 1.0F, 1e6F}) {
        const vec2 span = distanceSpan(scale, 1e5F * scale);
        const float kept = throughSixteenBits(encodeDistance(777.0F * scale, span));
        EXPECT_NEAR(decodeDistance(kept, span) / (777.0F * scale), 1.0F, 2e-4F);
    }
}

TEST(FalloffTest, ReachEndsWhereWeightsDo) {
    EXPECT_EQ(static_cast<int>(Falloff::Step), kFalloffStep);
    EXPECT_EQ(static_cast<int>(Falloff::Exp), kFalloffExp);
    EXPECT_EQ(static_cast<int>(Falloff::Off), kFalloffOff);
    const float radius = 0.3F;
    const float step = occluderReach(kFalloffStep, radius);
    EXPECT_EQ(occluderWeight(kFalloffStep, step, radius), 0.0F);
    EXPECT_EQ(occluderWeight(kFalloffStep, std::nextafter(step, 0.0F), radius), 1.0F);
    // Half a step of 16 bits, and not much less.
    const float left = occluderWeight(kFalloffExp, occluderReach(kFalloffExp, radius), radius);
    EXPECT_LT(left, 0.5F / 65535.0F);
    EXPECT_GT(left, 0.9F * 0.5F / 65535.0F);
    EXPECT_GE(occluderReach(kFalloffOff, radius), 1e29F);
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

TEST(NormalPairTest, BothNormalsComeBack) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    const auto anywhere = [&] {
        return normalize(vec3(normal(random), normal(random), normal(random)));
    };
    for (int i = 0; i < 100000; ++i) {
        const vec3 plane = anywhere();
        const vec3 shading = anywhere();
        const vec2 pair = encodeNormals(plane, shading);
        ASSERT_TRUE(isPair(pair));
        ASSERT_EQ(pair, vec2(ivec2(pair))) << "whole numbers, which no target rounds";
        ASSERT_LT(length(decodePlane(pair) - plane), 2e-4F);
        ASSERT_LT(length(decodeShading(pair) - shading), 5e-3F);
    }
    const float diagonal = std::sqrt(0.5F);
    for (const vec3 plane : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(-1, 0, 0), vec3(0, 1, 0),
                             vec3(diagonal, 0, -diagonal), vec3(0, -diagonal, diagonal)}) {
        const vec2 pair = encodeNormals(plane, anywhere());
        EXPECT_LT(length(decodePlane(pair) - plane), 1e-6F) << "no plane is tilted";
    }
}

TEST(NormalPairTest, OneNormalIsBoth) {
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    for (int i = 0; i < 1000; ++i) {
        const vec3 n = normalize(vec3(normal(random), normal(random), normal(random)));
        const vec2 alone = encodeNormal(n);
        EXPECT_FALSE(isPair(alone));
        EXPECT_EQ(decodePlane(alone), decodeNormal(alone));
        EXPECT_EQ(decodeShading(alone), decodeNormal(alone));
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
    // As a multiple of that at distance 2, and cosines 0.8 and 0.7.
    const auto relative = [](float d, float b, float c) {
        return qualityFactor(d * d, d * b, d * c) / qualityFactor(4.0F, 1.6F, 1.4F);
    };
    EXPECT_NEAR(relative(1.0F, 0.8F, 0.7F), 4.0F, 1e-5F) << "1/d^2";
    EXPECT_NEAR(relative(2.0F, 0.4F, 0.7F), 0.125F, 1e-6F) << "cos^3 beta";
    EXPECT_NEAR(relative(2.0F, 0.8F, 0.35F), 0.5F, 1e-6F) << "cos delta";
    EXPECT_NEAR(1e24F * relative(2e12F, 0.8F, 0.7F), 1.0F, 1e-4F);
    EXPECT_NEAR(1e-24F * relative(2e-12F, 0.8F, 0.7F), 1.0F, 1e-4F);
}

} // namespace
} // namespace aolib::shared
