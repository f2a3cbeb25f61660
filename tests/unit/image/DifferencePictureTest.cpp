#include "image/DifferencePicture.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(DifferencePicture, RedIsTooBrightBlueTooDark) {
    FloatImage test(7, 1, 1);
    FloatImage reference(7, 1, 1);
    test.pixels = {0.5F, 0.75F, 0.25F, 1.0F, 0.0F, -1.0F, 0.5F};
    reference.pixels = {0.5F, 0.5F, 0.5F, 0.0F, 1.0F, 0.5F, -1.0F};
    const auto picture = differencePicture(test, reference, 0.5F);
    ASSERT_TRUE(picture) << picture.error().message;
    const std::vector<std::uint8_t> expected{
        255, 255, 255, // equal
        255, 128, 128, // half the scale too bright
        128, 128, 255, // half the scale too dark
        255, 0,   0,   // beyond the scale
        0,   0,   255, //
        128, 128, 128, // background in the test
        128, 128, 128, // background in the reference
    };
    EXPECT_EQ(picture->channels, 3);
    EXPECT_EQ(picture->pixels, expected);
}

TEST(DifferencePicture, BadInputIsRefused) {
    const FloatImage image(2, 2, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(differencePicture(image, FloatImage(2, 3, 1), 1.0F).error().message,
              "sizes differ, the test is 2 x 2 x 1, the reference 2 x 3 x 1");
    EXPECT_EQ(differencePicture(image, FloatImage(2, 2, 1, nan), 1.0F).error().message,
              "the reference is NaN at pixel (0, 0)");
    for (const float scale : {0.0F, -1.0F, nan, std::numeric_limits<float>::infinity()}) {
        EXPECT_FALSE(differencePicture(image, image, scale));
    }
}

} // namespace
} // namespace aolib
