#include "image/Pfm.h"

#include <cmath>
#include <limits>

#include "TestFolder.h"

namespace aolib {
namespace {

class PfmTest : public test::InTestFolder {
protected:
    /// What readPfm() says after the file's name.
    std::string complaint(const std::string& bytes) const {
        const std::filesystem::path file = fileOf("bad.pfm", bytes);
        const auto image = readPfm(file);
        EXPECT_FALSE(image);
        const std::string start = file.string() + ": ";
        EXPECT_EQ(image.error().message.substr(0, start.size()), start);
        return image.error().message.substr(start.size());
    }
};

/// 1.0f is 3f800000, 2.0f 40000000, -1.0f bf800000, 0.5f 3f000000.
const std::string littleEndian = std::string("Pf\n2 2\n-1.0\n") + std::string("\x00\x00\x80\x3f"
                                                                              "\x00\x00\x00\x40"
                                                                              "\x00\x00\x80\xbf"
                                                                              "\x00\x00\x00\x3f",
                                                                              16);
const std::string bigEndian = std::string("Pf\n2 2\n1.0\n") + std::string("\x3f\x80\x00\x00"
                                                                          "\x40\x00\x00\x00"
                                                                          "\xbf\x80\x00\x00"
                                                                          "\x3f\x00\x00\x00",
                                                                          16);

/// The bottom row is 1, 2, the top row -1, 0.5.
FloatImage fourValues() {
    FloatImage image(2, 2, 1);
    image.at(0, 0) = 1.0F;
    image.at(1, 0) = 2.0F;
    image.at(0, 1) = -1.0F;
    image.at(1, 1) = 0.5F;
    return image;
}

TEST_F(PfmTest, WritesTheBottomRowFirstInLittleEndian) {
    ASSERT_FALSE(writePfm(path("a.pfm"), fourValues()));
    EXPECT_EQ(bytesOf(path("a.pfm")), littleEndian);
    EXPECT_EQ(names(), std::vector<std::string>{"a.pfm"});
}

TEST_F(PfmTest, ReadsBothByteOrders) {
    for (const std::string& bytes : {littleEndian, bigEndian}) {
        const auto image = readPfm(fileOf("a.pfm", bytes));
        ASSERT_TRUE(image) << image.error().message;
        EXPECT_EQ(*image, fourValues());
    }
}

TEST_F(PfmTest, ThreeChannelsRoundTripBitByBit) {
    FloatImage image(5, 3, 3);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = std::exp(static_cast<float>(i) - 20.0F);
    }
    image.pixels[7] = std::numeric_limits<float>::infinity();
    image.pixels[8] = std::numeric_limits<float>::denorm_min();
    ASSERT_FALSE(writePfm(path("a.pfm"), image));
    EXPECT_EQ(bytesOf(path("a.pfm")).substr(0, 12), "PF\n5 3\n-1.0\n");
    EXPECT_EQ(*readPfm(path("a.pfm")), image);
}

/// The first value's first byte may look like a blank; only one blank ends the header.
TEST_F(PfmTest, OneBlankEndsTheHeader) {
    const auto image = readPfm(fileOf("a.pfm", std::string("Pf 1\t1\r-2.5 \x20\x0a\x0d\x41", 16)));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_FLOAT_EQ(image->at(0, 0), 8.8149719F);
}

TEST_F(PfmTest, BadFilesAreRefused) {
    EXPECT_EQ(complaint(""), "not a PFM file, it does not begin with Pf or PF");
    EXPECT_EQ(complaint("Pf"), "not a PFM file, it does not begin with Pf or PF");
    EXPECT_EQ(complaint("P6\n2 2\n255\n"), "not a PFM file, it does not begin with Pf or PF");
    EXPECT_EQ(complaint(std::string(4096, 'x')), "not a PFM file, it does not begin with Pf or PF");
    EXPECT_EQ(complaint("Pf\n2\n"), "its header has no width and height");
    EXPECT_EQ(complaint("Pf\n2 two\n-1.0\n"), "its header has no width and height");
    EXPECT_EQ(complaint("Pf\n2.5 2\n-1.0\n"), "its header has no width and height");
    EXPECT_EQ(complaint("Pf\n99999999999 2\n-1.0\n"), "its header has no width and height");
    for (const char* scale : {"0", "nan", "inf", "x", "-1.0x"}) {
        EXPECT_EQ(complaint("Pf\n1 1\n" + std::string(scale) + "\n1234"),
                  "its header has no scale other than 0");
    }
    EXPECT_EQ(complaint("Pf\n1 1\n-1.0"), "its header has no scale other than 0");
}

TEST_F(PfmTest, AbsurdSizesAreRefused) {
    EXPECT_EQ(complaint("Pf\n0 2\n-1.0\n"),
              "its header says 0 x 2 pixels, must be 1 to 65536 each way");
    EXPECT_EQ(complaint("Pf\n2 -3\n-1.0\n"),
              "its header says 2 x -3 pixels, must be 1 to 65536 each way");
    EXPECT_EQ(complaint("Pf\n65537 1\n-1.0\n"),
              "its header says 65537 x 1 pixels, must be 1 to 65536 each way");
    EXPECT_EQ(complaint("PF\n65536 65536\n-1.0\n1234"),
              "truncated, 4 bytes of values where 65536 x 65536 pixels of 3 channels take "
              "51539607552");
}

TEST_F(PfmTest, EveryLengthButTheRightOneIsRefused) {
    for (std::size_t length = 0; length < littleEndian.size(); ++length) {
        EXPECT_FALSE(readPfm(fileOf("a.pfm", littleEndian.substr(0, length)))) << length;
    }
    EXPECT_EQ(complaint(littleEndian.substr(0, littleEndian.size() - 1)),
              "truncated, 15 bytes of values where 2 x 2 pixels of 1 channels take 16");
    EXPECT_EQ(complaint(littleEndian + "!"),
              "too long, 17 bytes of values where 2 x 2 pixels of 1 channels take 16");
}

TEST_F(PfmTest, BadPicturesAreNotWritten) {
    const auto message = [&](const FloatImage& image) {
        const ImageOutcome outcome = writePfm(path("a.pfm"), image);
        return outcome ? outcome->message : "";
    };
    EXPECT_EQ(message(FloatImage(1, 1, 2)),
              path("a.pfm").string() + ": PFM holds 1 or 3 channels, not 2");
    EXPECT_NE(message(FloatImage(0, 1, 1)), "");
    FloatImage image(2, 2, 1);
    image.pixels.pop_back();
    EXPECT_EQ(message(image),
              path("a.pfm").string() + ": the picture to write is 2 x 2 pixels but holds 3 values");
    EXPECT_TRUE(names().empty());
    EXPECT_TRUE(writePfm(path("no/folder.pfm"), fourValues()));
}

} // namespace
} // namespace aolib
