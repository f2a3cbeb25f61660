#include "image/Png16.h"

#include <string>

#include "TestFolder.h"
#include "image/Png.h"

namespace aolib {
namespace {

class Png16Test : public test::InTestFolder {
protected:
    ByteImage read(const std::vector<std::uint8_t>& content) const {
        const auto image = readPng(fileOf("a.png", std::string(content.begin(), content.end())));
        EXPECT_TRUE(image.ok()) << image.error().message;
        return image ? *image : ByteImage();
    }
};

TEST_F(Png16Test, EightBitsComeBackAsTheyWere) {
    for (const int channels : {1, 3}) {
        ByteImage image(13, 7, channels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] = static_cast<std::uint8_t>(41 * i * i + 3);
        }
        EXPECT_EQ(read(encodedPng(image)), image);
    }
}

TEST_F(Png16Test, SixteenBitsHaveTheirUpperBytesFirst) {
    WordImage image(5, 3, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = static_cast<std::uint16_t>(5003 * i + 77);
    }
    const std::vector<std::uint8_t> content = encodedPng(image);
    ASSERT_GT(content.size(), 25U);
    EXPECT_EQ(content[24], 16) << "the depth in the header";
    const ByteImage upper = read(content);
    ASSERT_EQ(upper.pixels.size(), image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_EQ(upper.pixels[i], image.pixels[i] >> 8U);
    }
    image.pixels[4] ^= 1U;
    EXPECT_NE(encodedPng(image), content) << "the lower bytes are lost";
}

TEST_F(Png16Test, WhatIsNoPictureHasNoContent) {
    EXPECT_TRUE(encodedPng(ByteImage()).empty());
    EXPECT_TRUE(encodedPng(ByteImage(2, 2, 2)).empty());
    ByteImage torn(2, 2, 1);
    torn.pixels.pop_back();
    EXPECT_TRUE(encodedPng(torn).empty());
}

} // namespace
} // namespace aolib
