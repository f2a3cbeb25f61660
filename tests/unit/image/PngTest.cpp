#include "image/Png.h"

#include <cstdint>
#include <string>

#include "TestFolder.h"

namespace aolib {
namespace {

class PngTest : public test::InTestFolder {};

/// A PNG of 1 x 2 grey pixels, made by hand: the upper one 10, the lower one 200. The pixel data is
/// one stored deflate block of two rows, each with filter type 0.
const std::string twoRows("\x89PNG\r\n\x1a\n"
                          "\x00\x00\x00\x0dIHDR\x00\x00\x00\x01\x00\x00\x00\x02\x08\x00\x00\x00\x00"
                          "\xbc\xea\xe9\xfb"
                          "\x00\x00\x00\x0fIDAT\x78\x01\x01\x04\x00\xfb\xff\x00\x0a\x00\xc8"
                          "\x00\xea\x00\xd3"
                          "\xd3\xfd\x71\x66"
                          "\x00\x00\x00\x00IEND\xae\x42\x60\x82",
                          72);

TEST_F(PngTest, TheBottomRowIsRowZero) {
    const auto image = readPng(fileOf("a.png", twoRows));
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(image->width, 1);
    ASSERT_EQ(image->height, 2);
    ASSERT_EQ(image->channels, 1);
    EXPECT_EQ(image->at(0, 0), 200);
    EXPECT_EQ(image->at(0, 1), 10);
}

TEST_F(PngTest, RoundTrips) {
    for (const int channels : {1, 3, 4}) {
        ByteImage image(7, 5, channels);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] = static_cast<std::uint8_t>(37 * i + 11);
        }
        ASSERT_FALSE(writePng(path("a.png"), image));
        const auto read = readPng(path("a.png"));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(*read, image) << channels;
    }
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

TEST_F(PngTest, BadFilesAreRefused) {
    const auto complaint = [&](const std::string& bytes) {
        const auto image = readPng(fileOf("bad.png", bytes));
        EXPECT_FALSE(image);
        return image.error().message;
    };
    const std::string start = path("bad.png").string() + ": not a PNG that can be read: ";
    for (const std::string& bytes :
         {std::string(), std::string("GIF89a"), std::string(1000, '\0'), twoRows.substr(0, 8),
          twoRows.substr(0, 30), twoRows.substr(0, 50)}) {
        EXPECT_EQ(complaint(bytes).substr(0, start.size()), start) << bytes.size();
    }
    std::string huge = twoRows;
    huge[16] = '\x7f';
    EXPECT_EQ(complaint(huge).substr(0, start.size()), start);
    EXPECT_NE(readPng(path("none.png")).error().message.find("none.png: cannot be opened"),
              std::string::npos);
}

TEST_F(PngTest, BadPicturesAreNotWritten) {
    EXPECT_EQ(writePng(path("a.png"), ByteImage(1, 1, 2))->message,
              path("a.png").string() + ": PNG is written with 1, 3 or 4 channels, not 2");
    EXPECT_TRUE(writePng(path("a.png"), ByteImage(0, 1, 1)));
    EXPECT_TRUE(writePng(path("a.png"), ByteImage(65537, 1, 1)));
    ByteImage image(2, 2, 3);
    image.pixels.pop_back();
    EXPECT_EQ(writePng(path("a.png"), image)->message,
              path("a.png").string() +
                  ": the picture to write is 2 x 2 pixels and holds 11 values");
    EXPECT_TRUE(names().empty());
}

} // namespace
} // namespace aolib
