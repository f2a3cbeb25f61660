#include <gtest/gtest.h>

#include <cmath>

#include "viewer/ViewError.h"

namespace aolib::viewer {
namespace {

FloatImage imageOf(std::vector<float> values) {
    FloatImage image(static_cast<int>(values.size()), 1, 1);
    image.pixels = std::move(values);
    return image;
}

TEST(ViewErrorTest, IsOverPixelsThatBothKnow) {
    const auto error =
        viewError(imageOf({0.5F, -1.0F, 1.0F, 0.2F}), imageOf({0.4F, 0.3F, -1.0F, 0.4F}), 0.0);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->pixels, 2U);
    EXPECT_NEAR(error->bias, -0.05, 1e-6);
    EXPECT_NEAR(error->rmse, std::sqrt((0.01 + 0.04) / 2.0), 1e-6);
}

TEST(ViewErrorTest, TheTruthsNoiseIsTakenOff) {
    const auto error = viewError(imageOf({0.5F}), imageOf({0.0F}), 0.3);
    EXPECT_NEAR(error->rmse, 0.4, 1e-6);
    EXPECT_EQ(viewError(imageOf({0.5F}), imageOf({0.4F}), 0.3)->rmse, 0.0);
}

TEST(ViewErrorTest, NeedsSomethingToCompare) {
    EXPECT_FALSE(viewError(imageOf({0.5F}), imageOf({0.4F, 0.1F}), 0.0));
    EXPECT_FALSE(viewError(imageOf({-1.0F}), imageOf({0.4F}), 0.0));
}

} // namespace
} // namespace aolib::viewer
