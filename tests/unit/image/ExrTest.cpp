#include "image/Exr.h"

#include <cstring>
#include <string>

#include <gtest/gtest.h>

namespace aolib {
namespace {

std::uint32_t u32At(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes.at(at), 4);
    return value;
}

float realAt(const std::vector<std::uint8_t>& bytes, std::size_t at) {
    float value = 0.0F;
    std::memcpy(&value, &bytes.at(at), 4);
    return value;
}

TEST(ExrTest, HeaderTableAndRowsLieAsTheFileLayoutSays) {
    FloatImage image(2, 2, 3);
    for (int i = 0; i < 12; ++i) {
        image.pixels[static_cast<std::size_t>(i)] = float(i);
    }
    const std::vector<std::uint8_t> bytes = encodedExr(image);
    EXPECT_EQ(u32At(bytes, 0), 0x01312f76U);
    EXPECT_EQ(u32At(bytes, 4), 2U);
    const std::string text(bytes.begin(), bytes.end());
    const std::size_t list = text.find(std::string("chlist") + '\0');
    ASSERT_NE(list, std::string::npos);
    EXPECT_EQ(u32At(bytes, list + 7), 3U * 18U + 1U);
    EXPECT_EQ(text.substr(list + 11, 2), std::string("B\0", 2));
    // The file ends with two rows of 8 + 24 bytes, and their places stand before them.
    const std::size_t first = bytes.size() - 2 * 32;
    EXPECT_EQ(u32At(bytes, first - 16), first);
    EXPECT_EQ(u32At(bytes, first - 8), first + 32);
    EXPECT_EQ(u32At(bytes, first), 0U);
    EXPECT_EQ(u32At(bytes, first + 4), 24U);
    // The top row's blue values, then green; the bottom row's red ones at the end.
    EXPECT_EQ(realAt(bytes, first + 8), 8.0F);
    EXPECT_EQ(realAt(bytes, first + 12), 11.0F);
    EXPECT_EQ(realAt(bytes, first + 16), 7.0F);
    EXPECT_EQ(realAt(bytes, bytes.size() - 8), 0.0F);
    EXPECT_EQ(realAt(bytes, bytes.size() - 4), 3.0F);
}

TEST(ExrTest, OneChannelIsLuminanceAndOthersAreNotWritten) {
    const std::vector<std::uint8_t> bytes = encodedExr(FloatImage(3, 1, 1, 0.25F));
    const std::string text(bytes.begin(), bytes.end());
    EXPECT_EQ(text.substr(text.find("chlist") + 11, 2), std::string("Y\0", 2));
    EXPECT_EQ(realAt(bytes, bytes.size() - 4), 0.25F);
    EXPECT_TRUE(encodedExr(FloatImage(3, 1, 2)).empty());
    EXPECT_TRUE(encodedExr(FloatImage()).empty());
}

} // namespace
} // namespace aolib
