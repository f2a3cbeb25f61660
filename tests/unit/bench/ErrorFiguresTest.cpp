#include "bench/ErrorFigures.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "raytracing/CosineSampling.h"

namespace aolib::bench {
namespace {

Truth truthOf(std::vector<float> values, float noise = 0.0F) {
    Truth truth;
    truth.standardError.assign(values.size(), noise);
    for (std::uint32_t i = 0; i < values.size(); ++i) {
        truth.receivers.pixels.push_back(2 * i); // every other pixel of a picture
    }
    truth.visibility = std::move(values);
    return truth;
}

TEST(ErrorFigures, AreThoseOfTheDifferences) {
    const Truth truth = truthOf({0.5F, 0.5F, 0.5F, 0.5F});
    const ErrorFigures figures = comparePoints(std::vector{0.75F, 0.25F, 0.5F, 1.0F}, truth);
    EXPECT_NEAR(figures.rmse, std::sqrt((0.0625 + 0.0625 + 0.25) / 4.0), 1e-9);
    EXPECT_NEAR(figures.bias, 0.125, 1e-9);
    EXPECT_NEAR(figures.maximum, 0.5, 1e-9);
    EXPECT_NEAR(figures.percentile95, 0.5, 1e-9);
    EXPECT_EQ(figures.missing, 0.0);
}

TEST(ErrorFigures, TakeTheNoiseOfTheTruthOff) {
    constexpr int count = 20000;
    constexpr double noise = 0.05;
    RandomSequence random(1, 1);
    std::vector<float> noisy;
    for (int i = 0; i < count; ++i) { // uniform, with this standard deviation
        noisy.push_back(static_cast<float>(0.5 + noise * std::sqrt(12.0) * (random.next() - 0.5)));
    }
    const std::vector<float> values(count, 0.6F);
    const ErrorFigures figures = comparePoints(values, truthOf(noisy, float(noise)));
    EXPECT_NEAR(figures.rmse, 0.1, 0.003);
}

TEST(ErrorFigures, LookUpPixelsAndCountMissingSurfaces) {
    const Truth truth = truthOf({0.5F, 0.5F});
    const std::vector<float> picture{0.5F, 9.0F, -1.0F, 9.0F};
    const ErrorFigures figures = compareWithTruth(picture, truth);
    EXPECT_EQ(figures.rmse, 0.0);
    EXPECT_EQ(figures.missing, 0.5);
}

TEST(ErrorFigures, CountWhatIsNoNumberAsTheWorst) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinite = -std::numeric_limits<float>::infinity();
    const ErrorFigures figures =
        comparePoints(std::vector{nan, 0.5F, infinite, 0.5F}, truthOf({0.5F, 0.5F, 0.5F, 0.5F}));
    EXPECT_EQ(figures.notNumbers, 2U);
    EXPECT_NEAR(figures.rmse, std::sqrt(0.5), 1e-9);
    EXPECT_EQ(figures.maximum, 1.0);
}

TEST(ErrorFigures, AreUnknownWithoutPoints) {
    EXPECT_LT(comparePoints(std::vector{-1.0F}, truthOf({0.5F})).rmse, 0.0);
}

} // namespace
} // namespace aolib::bench
