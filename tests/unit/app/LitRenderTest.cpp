#include <algorithm>
#include <fstream>

#include "Program.h"
#include "image/Pfm.h"
#include "image/Png.h"

namespace aolib::test {
namespace {

class LitRenderTest : public ProgramTest {
protected:
    ProgramRun lit(std::vector<std::string> more) const {
        std::vector<std::string> arguments{"render",           "cornell", "--width",    "48",
                                           "--height",         "27",      "--lit-rays", "16",
                                           "--lit-truth-rays", "64",      "--lit-edge", "4"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    }
    void expectRefused(const std::vector<std::string>& more, const std::string& word) const {
        const ProgramRun refused = lit(more);
        EXPECT_EQ(refused.exitCode, 2) << refused.out << refused.err;
        EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
    }
};

TEST_F(LitRenderTest, APictureIsLitTracedAndCompared) {
    const ProgramRun done =
        lit({"--environment", "overcast", "--lit", "lit.pfm", "--lit-truth", "truth.png"});
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_NE(done.out.find("RMSE against 64 rays"), std::string::npos) << done.out;
    EXPECT_EQ(names(), (std::vector<std::string>{"lit.pfm", "truth.png"}));
    const auto picture = readPfm(path("lit.pfm"));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(picture->channels, 3);
    // Radiance of the sky itself: up to 1 at the zenith.
    const auto [least, most] = std::minmax_element(picture->pixels.begin(), picture->pixels.end());
    EXPECT_GE(*least, 0.0F);
    EXPECT_LE(*most, 1.01F);
    EXPECT_GT(*most, 0.2F);
    ASSERT_TRUE(readPng(path("truth.png")));
}

TEST_F(LitRenderTest, AFileWillDoAndCanBeTurned) {
    // One bright texel of four in a row.
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n";
    for (const int exponent : {130, 0, 0, 0}) {
        for (const int value : {128, 128, 128, exponent}) {
            bytes.push_back(static_cast<char>(exponent == 0 ? 0 : value));
        }
    }
    std::ofstream(path("sky.hdr"), std::ios::binary) << bytes;
    ASSERT_EQ(lit({"--environment", "sky.hdr", "--lit", "a.pfm"}).exitCode, 0);
    ASSERT_EQ(lit({"--environment", "sky.hdr", "--lit", "b.pfm", "--turn", "180"}).exitCode, 0);
    ASSERT_EQ(lit({"--environment", "sky.hdr", "--lit", "c.pfm", "--turn", "360"}).exitCode, 0);
    EXPECT_NE(readPfm(path("a.pfm"))->pixels, readPfm(path("b.pfm"))->pixels);
    EXPECT_EQ(readPfm(path("a.pfm"))->pixels, readPfm(path("c.pfm"))->pixels);
}

TEST_F(LitRenderTest, WhatCannotBeUsedIsRefused) {
    expectRefused({"--environment", "sunny"}, "--lit");
    expectRefused({"--environment", "moon", "--lit", "a.png"}, "sunny");
    expectRefused({"--environment", "missing.hdr", "--lit", "a.png"}, "missing.hdr");
    expectRefused({"--environment", "sunny", "--lit", "a.jpg"}, "--lit");
    expectRefused({"--environment", "sunny", "--lit", "a.png", "--exposure", "-1"}, "--exposure");
    expectRefused({"--environment", "sunny", "--lit", "a.png", "--lit-edge", "0"}, "--lit-edge");
    EXPECT_TRUE(names().empty());
}

} // namespace
} // namespace aolib::test
