#include "raytracing/SobolSequence.h"

#include <cstdint>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace aolib {
namespace {

/// The cell that a point falls into when the sides are halved `across` and `along` times.
std::pair<std::uint32_t, std::uint32_t> cellOf(std::uint32_t first, std::uint32_t second,
                                               int across, int along) {
    const auto coarsest = [](std::uint32_t reversed, int bits) {
        return bits == 0 ? 0U : bitReversed(reversed) >> static_cast<unsigned>(32 - bits);
    };
    return {coarsest(first, across), coarsest(second, along)};
}

TEST(SobolSequence, BitsAreReversed) {
    EXPECT_EQ(bitReversed(1U), 0x80000000U);
    EXPECT_EQ(bitReversed(0x00000d00U), 0x00b00000U);
    EXPECT_EQ(bitReversed(bitReversed(0x12345678U)), 0x12345678U);
}

/// The first points of the second dimension: 0, 1/2, 3/4, 1/4, 5/8, 1/8, 3/8, 7/8.
TEST(SobolSequence, SecondDimensionBeginsAsPublished) {
    const std::uint32_t eighths[] = {0, 4, 6, 2, 5, 1, 3, 7};
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(bitReversed(sobolSecond(i)), eighths[i] << 29U) << i;
    }
}

TEST(SobolSequence, EveryAlignedBlockFillsEveryCellOfEveryShape) {
    for (const std::uint32_t start : {0U, 256U, 768U, 1048576U}) {
        const SequenceSeed seed = sequenceSeed(3, static_cast<int>(start % 511U), 17);
        for (int across = 0; across <= 8; ++across) {
            std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
            for (std::uint32_t i = start; i < start + 256; ++i) {
                cells.insert(cellOf(scrambled(i, seed.first),
                                    scrambled(sobolSecond(i), seed.second), across, 8 - across));
            }
            EXPECT_EQ(cells.size(), 256U) << start << " cut into " << (1 << across) << " columns";
        }
    }
}

TEST(SobolSequence, SeedsOfTexelsDiffer) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> seeds;
    for (int face = 0; face < 6; ++face) {
        for (int y = 0; y < 65536; y += 4095) {
            for (int x = 0; x < 65536; x += 4095) {
                const SequenceSeed seed = sequenceSeed(face, x, y);
                seeds.insert({seed.first, seed.second});
            }
        }
    }
    EXPECT_EQ(seeds.size(), 6U * 17U * 17U);
}

/// Over many texels every ray is equally likely in every part of the square.
TEST(SobolSequence, EachRayIsUniformOverTexels) {
    for (const std::uint32_t index : {0U, 1U, 6U, 100U}) {
        int counts[16] = {};
        for (int x = 0; x < 4096; ++x) {
            const SequenceSeed seed = sequenceSeed(1, x, 5);
            const auto cell = cellOf(scrambled(index, seed.first),
                                     scrambled(sobolSecond(index), seed.second), 2, 2);
            ++counts[cell.first * 4 + cell.second];
        }
        for (const int count : counts) {
            EXPECT_NEAR(count, 256, 5 * 16) << "ray " << index; // five standard deviations
        }
    }
}

} // namespace
} // namespace aolib
