#include "image/Metrics.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace aolib {
namespace {

FloatImage row(const std::vector<float>& values) {
    FloatImage image(static_cast<int>(values.size()), 1, 1);
    image.pixels = values;
    return image;
}

TEST(Metrics, ByHand) {
    // Errors 0.25, -0.5, 0, 0.25; the rest is background somewhere.
    const auto metrics = compareImages(row({0.75F, 0.25F, 1.0F, 0.25F, -1.0F, 0.5F, -1.0F, -1.0F}),
                                       row({0.5F, 0.75F, 1.0F, 0.0F, 0.5F, -1.0F, -1.0F, 0.5F}));
    ASSERT_TRUE(metrics) << metrics.error().message;
    EXPECT_EQ(metrics->pixels, 4U);
    EXPECT_EQ(metrics->backgroundOnlyInTest, 2U);
    EXPECT_EQ(metrics->backgroundOnlyInReference, 1U);
    EXPECT_DOUBLE_EQ(metrics->rmse, std::sqrt(0.375 / 4.0));
    EXPECT_DOUBLE_EQ(metrics->mae, 0.25);
    EXPECT_DOUBLE_EQ(metrics->bias, 0.0);
    EXPECT_DOUBLE_EQ(metrics->maximum, 0.5);
    EXPECT_DOUBLE_EQ(metrics->percentile95, 0.5);
    EXPECT_DOUBLE_EQ(metrics->psnr, 10.0 * std::log10(4.0 / 0.375));
    EXPECT_FALSE(metrics->ssim);
}

TEST(Metrics, BiasIsTestMinusReference) {
    EXPECT_DOUBLE_EQ(compareImages(row({0.25F, 0.5F}), row({0.5F, 0.75F}))->bias, -0.25);
    EXPECT_DOUBLE_EQ(compareImages(row({0.5F, 0.75F}), row({0.25F, 0.5F}))->bias, 0.25);
}

TEST(Metrics, PercentileIsTheNearestRank) {
    for (const auto& [count, expected] :
         {std::pair(1, 1.0), std::pair(19, 19.0), std::pair(20, 19.0), std::pair(21, 20.0),
          std::pair(100, 95.0), std::pair(200, 190.0)}) {
        std::vector<float> values;
        for (int i = 0; i < count; ++i) {
            values.push_back(static_cast<float>((i * 11) % count + 1)); // 1 to count, shuffled
        }
        const auto metrics =
            compareImages(row(values), row(std::vector<float>(values.size(), 0.0F)));
        EXPECT_DOUBLE_EQ(metrics->percentile95, expected) << count;
    }
}

TEST(Metrics, EqualPictures) {
    const FloatImage image(16, 12, 1, 0.3F);
    const auto metrics = compareImages(image, image);
    EXPECT_EQ(metrics->pixels, 192U);
    EXPECT_EQ(metrics->rmse, 0.0);
    EXPECT_EQ(metrics->maximum, 0.0);
    EXPECT_EQ(metrics->psnr, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(metrics->ssim.value(), 1.0, 1e-12);
}

TEST(Metrics, SizesMustMatch) {
    EXPECT_EQ(compareImages(FloatImage(4, 3, 1), FloatImage(3, 4, 1)).error().message,
              "sizes differ, the test is 4 x 3 x 1, the reference 3 x 4 x 1");
    EXPECT_EQ(compareImages(FloatImage(4, 3, 1), FloatImage(4, 3, 3)).error().message,
              "sizes differ, the test is 4 x 3 x 1, the reference 4 x 3 x 3");
    EXPECT_FALSE(compareImages(FloatImage(4, 3, 3), FloatImage(4, 3, 3)));
    EXPECT_FALSE(compareImages(FloatImage(), FloatImage()));
    FloatImage image(4, 3, 1);
    image.pixels.pop_back();
    EXPECT_FALSE(compareImages(FloatImage(4, 3, 1), image));
}

TEST(Metrics, ValuesMustBeFinite) {
    FloatImage bad(4, 3, 1);
    bad.at(2, 1) = std::numeric_limits<float>::quiet_NaN();
    const FloatImage good(4, 3, 1);
    EXPECT_EQ(compareImages(bad, good).error().message, "the test is NaN at pixel (2, 1)");
    EXPECT_EQ(compareImages(good, bad).error().message, "the reference is NaN at pixel (2, 1)");
    bad.at(3, 0) = -std::numeric_limits<float>::infinity();
    EXPECT_EQ(compareImages(bad, good).error().message, "the test is infinite at pixel (3, 0)");
}

TEST(Metrics, SomethingMustBeLeftToCompare) {
    EXPECT_EQ(compareImages(row({-1.0F, 0.5F}), row({0.5F, -1.0F})).error().message,
              "there is no pixel to compare, each is background in one picture");
}

} // namespace
} // namespace aolib
