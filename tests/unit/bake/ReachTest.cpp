#include "bake/gpu/Reach.h"

#include <cmath>

#include <gtest/gtest.h>

namespace aolib::bake {

namespace {

/// The share of the first `count` directions whose radius is beyond a distance.
double shareBeyond(const Reach& reach, double distance, std::uint32_t count, std::uint32_t seed) {
    std::uint32_t beyond = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        beyond += drawRadius(reach, seed, i) > distance ? 1U : 0U;
    }
    return double(beyond) / double(count);
}

TEST(ReachTest, RadiiOfExpAreItsMixtureOfStepsInEveryPrefix) {
    const Reach reach{0.2, Falloff::Exp};
    for (const std::uint32_t seed : {0U, 5U}) {
        for (const std::uint32_t count : {16U, 64U, 1024U}) {
            for (const double distance : {0.02, 0.1, 0.2, 0.4, 0.8}) {
                // One radius in each of `count` equal shares of the distribution.
                EXPECT_NEAR(shareBeyond(reach, distance, count, seed), std::exp(-distance / 0.2),
                            1.0 / count)
                    << count << ' ' << distance;
            }
        }
    }
    EXPECT_GE(drawRadius(reach, 0, 77), 0.2 / 64.0);
}

TEST(ReachTest, StepHasOneRadiusAndNoRadiusHasNoEnd) {
    EXPECT_EQ(shareBeyond({0.2, Falloff::Step}, 0.19, 16, 0), 1.0);
    EXPECT_EQ(shareBeyond({0.2, Falloff::Step}, 0.2, 16, 0), 0.0);
    EXPECT_TRUE(std::isinf(drawRadius({0.0, Falloff::Exp}, 0, 3)));
    EXPECT_TRUE(std::isinf(drawRadius({0.2, Falloff::Off}, 0, 3)));
}

TEST(ReachTest, TooSmallARadiusIsRefusedWithTheLeast) {
    EXPECT_TRUE(checkReach({0.1, Falloff::Step}, 1.0).ok());
    EXPECT_TRUE(checkReach({0.0, Falloff::Step}, 1.0).ok());
    const AoStatus status = checkReach({0.001, Falloff::Step}, 0.5);
    EXPECT_EQ(status.code(), StatusCode::InvalidOption);
    EXPECT_NE(status.message().find("at least 0.0078"), std::string::npos) << status.message();
}

} // namespace

} // namespace aolib::bake
