#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "content/EnvironmentSource.h"
#include "content/HdrReader.h"
#include "content/generated/Environments.h"

namespace aolib {
namespace {

/// A Radiance file of two rows of three texels: red 1, green 2, blue 4 above; 0.5, 0, 100 below.
std::string smallHdr() {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 3\n";
    const auto texel = [&](int r, int g, int b, int exponent) {
        for (const int value : {r, g, b, exponent}) {
            bytes.push_back(static_cast<char>(value));
        }
    };
    texel(128, 0, 0, 129); // 1 = 128 / 256 * 2^1
    texel(0, 128, 0, 130);
    texel(0, 0, 128, 131);
    texel(128, 128, 128, 128);
    texel(0, 0, 0, 0);
    texel(200, 200, 200, 135);
    return bytes;
}

TEST(HdrReaderTest, RowsAreTurnedOverAndExponentsRead) {
    const auto map = readHdr(smallHdr(), "small.hdr");
    ASSERT_TRUE(map) << map.error().sentence;
    ASSERT_EQ(map->width, 3);
    ASSERT_EQ(map->height, 2);
    EXPECT_EQ(map->radiance[3], glm::vec3(1, 0, 0)) << "the upper row comes last";
    EXPECT_EQ(map->radiance[4], glm::vec3(0, 2, 0));
    EXPECT_EQ(map->radiance[5], glm::vec3(0, 0, 4));
    EXPECT_EQ(map->radiance[0], glm::vec3(0.5F));
    EXPECT_EQ(map->radiance[1], glm::vec3(0.0F));
    EXPECT_EQ(map->radiance[2], glm::vec3(100.0F));
}

TEST(HdrReaderTest, WhatIsNoneOrCutOffIsRefusedByName) {
    const std::string good = smallHdr();
    EXPECT_NE(readHdr("\x89PNG", "a.hdr").error().sentence.find("a.hdr"), std::string::npos);
    EXPECT_FALSE(readHdr("", "a.hdr"));
    EXPECT_FALSE(readHdr("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 99999\n", "a.hdr"));
    EXPECT_FALSE(readHdr("#?RADIANCE\nFORMAT=xyz\n\n-Y 2 +X 3\n", "a.hdr"));
}

TEST(EnvironmentSourceTest, NamesAndFilesAreFound) {
    const auto generated = openEnvironment("studio");
    ASSERT_TRUE(generated);
    EXPECT_EQ(generated->radiance, findGeneratedEnvironment("studio")->build().radiance);
    const std::filesystem::path folder(AOLIB_TEST_FOLDER);
    std::filesystem::create_directories(folder);
    const std::filesystem::path file = folder / "small.hdr";
    std::ofstream(file, std::ios::binary) << smallHdr();
    const auto read = openEnvironment(file.string());
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->width, 3);
    EXPECT_NE(openEnvironment("nonsense").error().sentence.find("sunny"), std::string::npos);
    EXPECT_NE(openEnvironment("missing.hdr").error().sentence.find("missing.hdr"),
              std::string::npos);
}

TEST(EnvironmentSourceTest, GeneratedOnesAreGood) {
    for (const GeneratedEnvironment& environment : generatedEnvironments()) {
        EXPECT_TRUE(lighting::checkEnvironment(environment.build())) << environment.name;
    }
    EXPECT_EQ(findGeneratedEnvironment("moon"), nullptr);
}

} // namespace
} // namespace aolib
