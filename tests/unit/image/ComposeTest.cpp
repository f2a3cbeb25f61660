#include "image/Compose.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "image/FalseColour.h"

namespace aolib {
namespace {

std::vector<std::uint8_t> pixel(const ByteImage& image, int x, int y) {
    return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

using Rgb = std::vector<std::uint8_t>;

TEST(FalseColour, GreyPictureOfVisibility) {
    FloatImage w(6, 1, 1);
    w.pixels = {0.0F, 1.0F, 0.5F, 1.5F, -1.0F, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_EQ(greyPicture(w).pixels, (std::vector<std::uint8_t>{0, 255, 128, 255, 255, 255}));
    EXPECT_EQ(greyPicture(w, 7).pixels, (std::vector<std::uint8_t>{0, 255, 128, 255, 7, 7}));
}

TEST(FalseColour, RgbOfEveryChannelCount) {
    ByteImage picture(2, 1, 2);
    picture.pixels = {1, 100, 2, 100};
    EXPECT_EQ(rgbPicture(picture).pixels, (std::vector<std::uint8_t>{1, 1, 1, 2, 2, 2}));
    picture = ByteImage(2, 1, 4);
    picture.pixels = {1, 2, 3, 100, 4, 5, 6, 100};
    EXPECT_EQ(rgbPicture(picture).pixels, (std::vector<std::uint8_t>{1, 2, 3, 4, 5, 6}));
    picture = ByteImage(1, 1, 1, 9);
    EXPECT_EQ(rgbPicture(picture).pixels, (std::vector<std::uint8_t>{9, 9, 9}));
}

TEST(Compose, StripKeepsOrderAndAlignsBottoms) {
    ByteImage low(2, 1, 1);
    low.pixels = {10, 20};
    ByteImage high(1, 2, 3);
    high.pixels = {1, 2, 3, 4, 5, 6};
    const auto strip = sideBySide(std::vector<ByteImage>{low, high});
    ASSERT_TRUE(strip) << strip.error().message;
    ASSERT_EQ(strip->width, 2 + separatorWidth + 1);
    ASSERT_EQ(strip->height, 2);
    ASSERT_EQ(strip->channels, 3);
    const Rgb separator(3, 64);
    EXPECT_EQ(pixel(*strip, 0, 0), Rgb(3, 10));
    EXPECT_EQ(pixel(*strip, 1, 0), Rgb(3, 20));
    EXPECT_EQ(pixel(*strip, 0, 1), separator);
    EXPECT_EQ(pixel(*strip, 1, 1), separator);
    for (int y = 0; y < 2; ++y) {
        for (int x = 2; x < 2 + separatorWidth; ++x) {
            EXPECT_EQ(pixel(*strip, x, y), separator);
        }
    }
    EXPECT_EQ(pixel(*strip, 2 + separatorWidth, 0), (Rgb{1, 2, 3}));
    EXPECT_EQ(pixel(*strip, 2 + separatorWidth, 1), (Rgb{4, 5, 6}));
}

TEST(Compose, OnePictureHasNoSeparator) {
    EXPECT_EQ(*sideBySide(std::vector<ByteImage>{ByteImage(3, 2, 3, 5)}), ByteImage(3, 2, 3, 5));
}

TEST(Compose, BadInputIsRefused) {
    EXPECT_FALSE(sideBySide({}));
    EXPECT_EQ(
        sideBySide(std::vector<ByteImage>{ByteImage(1, 1, 1), ByteImage(0, 1, 1)}).error().message,
        "picture 1 of a strip is 0 x 1 x 1 and holds 0 values");
    EXPECT_FALSE(sideBySide(std::vector<ByteImage>{ByteImage(1, 1, 5)}));
    EXPECT_FALSE(
        sideBySide(std::vector<ByteImage>{ByteImage(60000, 1, 1), ByteImage(60000, 1, 1)}));
}

} // namespace
} // namespace aolib
