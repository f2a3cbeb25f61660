#include "backbone/texels/TileTurns.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace aolib {
namespace {

using Keys = std::vector<std::uint64_t>;
using Tiles = std::vector<TileTurns::Tile>;

constexpr double kRaysOfFirst = 16.0;
constexpr double kRaysOfRefined = 128.0;

Tiles tiles(std::uint64_t from, std::uint64_t to, double rays, bool again) {
    Tiles list;
    for (std::uint64_t key = from; key < to; ++key) {
        list.push_back({key, rays, again});
    }
    return list;
}

TEST(TileTurnsTest, WhatShowsNothingComesBeforeAllElse) {
    TileTurns turns;
    const Tiles first = tiles(0, 3, kRaysOfFirst, false);
    const Tiles refined = tiles(10, 12, kRaysOfRefined, true);
    EXPECT_FALSE(turns.has(first));
    EXPECT_EQ(turns.order(first, refined, 10), (Keys{0, 1, 2, 10, 11}));
    EXPECT_TRUE(turns.has(first));
    EXPECT_EQ(turns.order(first, refined, 4), (Keys{0, 1, 2, 10}));
    EXPECT_FALSE(turns.has(tiles(2, 4, kRaysOfFirst, false)));
    EXPECT_TRUE(turns.order({}, {}, 10).empty());
}

/// Forty tiles begin again in every frame, of which a tracer can do ten in it.
TEST(TileTurnsTest, WhatBeginsAgainForEverLeavesAThirdToTheOthers) {
    TileTurns turns;
    const Tiles first = tiles(0, 40, kRaysOfFirst, true);
    const Tiles refined = tiles(100, 200, kRaysOfRefined, true);
    double ofFirst = 0.0;
    double ofRefined = 0.0;
    for (int frame = 0; frame < 2000; ++frame) {
        double left = 10.0 * kRaysOfFirst;
        for (const std::uint64_t key : turns.order(first, refined, 512)) {
            if (left <= 0.0) {
                break;
            }
            const bool isRefined = key >= 100;
            const TileTurns::Tile& tile = isRefined ? refined[key - 100] : first[key];
            (isRefined ? ofRefined : ofFirst) += tile.rays;
            left -= tile.rays;
            turns.answered(tile, isRefined);
        }
    }
    EXPECT_NEAR(ofRefined / (ofFirst + ofRefined), 1.0 / 3.0, 0.05);
}

TEST(TileTurnsTest, WhatMayBeUnderWayIsNotOrderedTwice) {
    TileTurns turns;
    const Tiles first = tiles(0, 40, kRaysOfFirst, true);
    const Tiles refined = tiles(100, 102, kRaysOfRefined, true);
    for (const TileTurns::Tile& tile : first) {
        turns.answered(tile, false);
    }
    const Keys begun = turns.order(first, refined, 1);
    ASSERT_EQ(begun, Keys{100}) << "it is owed";
    EXPECT_EQ(turns.order(first, refined, 1), Keys{101}) << "100 is perhaps under way";
    turns.answered(refined[1], true);
    turns.answered(refined[0], true);
    EXPECT_EQ(turns.order({}, refined, 5), (Keys{100, 101})) << "nothing else is to do";
}

} // namespace
} // namespace aolib
