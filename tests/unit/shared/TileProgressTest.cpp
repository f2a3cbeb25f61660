#include "backbone/cubemapped/TileProgress.h"

#include <set>

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(TileProgressTest, TilesCoverEveryTexelOnce) {
    for (const int size : {16, 32, 100, 512}) {
        const TileProgress tiles(size);
        std::set<std::tuple<int, int, int>> texels;
        for (int tile = 0; tile < tiles.count(); ++tile) {
            const TileProgress::Region region = tiles.region(tile);
            for (int y = 0; y < region.height; ++y) {
                for (int x = 0; x < region.width; ++x) {
                    EXPECT_TRUE(texels.insert({region.face, region.x + x, region.y + y}).second);
                }
            }
        }
        EXPECT_EQ(texels.size(), static_cast<std::size_t>(kFaces * size * size));
    }
}

TEST(TileProgressTest, OnlyWhatIsAskedForIsUrgent) {
    TileProgress tiles(128);
    EXPECT_EQ(tiles.fewestPasses(), -1);
    EXPECT_FALSE(tiles.lacks(1)) << "nothing is asked for, nothing is lacking";
    tiles.ask(2, {48.0F, 80.0F});
    ASSERT_EQ(tiles.mostUrgent(4).size(), 1U) << "the middle of a tile";
    const TileProgress::Region region = tiles.region(tiles.mostUrgent(4)[0]);
    EXPECT_EQ(region.face, 2);
    EXPECT_EQ(region.x, 32);
    EXPECT_EQ(region.y, 64);
    tiles.ask(2, {65.0F, 80.0F});
    EXPECT_EQ(tiles.mostUrgent(4).size(), 2U)
        << "beside a border, both tiles; one is asked already";
    tiles.ask(5, {0.0F, 128.0F});
    EXPECT_EQ(tiles.mostUrgent(4).size(), 3U) << "a face's corner is no overrun";
}

TEST(TileProgressTest, ThePoorestComeFirst) {
    TileProgress tiles(64);
    tiles.askAll();
    EXPECT_EQ(tiles.mostUrgent(2).size(), static_cast<std::size_t>(tiles.count()));
    for (int tile = 0; tile < tiles.count(); ++tile) {
        tiles.setPasses(tile, tile == 3 ? 0 : 1);
    }
    EXPECT_EQ(tiles.mostUrgent(2), std::vector<int>{3});
    tiles.setPasses(3, 1);
    EXPECT_TRUE(tiles.lacks(2));
    EXPECT_FALSE(tiles.lacks(1));
    EXPECT_TRUE(tiles.mostUrgent(1).empty());
    tiles.forget();
    EXPECT_EQ(tiles.fewestPasses(), 0);
    EXPECT_TRUE(tiles.asked(0)) << "what was asked for stays";
}

TEST(TileProgressTest, BlocksAreAskedForOneAfterTheOther) {
    constexpr int kPerBlock = 4;
    TileProgress tiles(64);
    const glm::vec2 middle(16.0F, 16.0F);
    tiles.ask(0, middle);
    EXPECT_EQ(tiles.blocksNeeded(0), 0) << "nobody asks";
    tiles.ask(0, middle, kPerBlock);
    EXPECT_EQ(tiles.blocksNeeded(0), 0) << "nothing is offered";
    tiles.offerBlocks(0, 2);
    EXPECT_EQ(tiles.blocksNeeded(0), 1);
    EXPECT_TRUE(tiles.lacksBlocks(kPerBlock));
    tiles.setBlockPasses(0, kPerBlock - 1);
    tiles.ask(0, middle, kPerBlock);
    EXPECT_EQ(tiles.blocksNeeded(0), 1) << "one is on its way";
    EXPECT_EQ(tiles.share(8, 3).needed, 8 + 3 * 8);
    EXPECT_EQ(tiles.share(8, 3).done, 3 * (kPerBlock - 1));
    tiles.setBlockPasses(0, kPerBlock);
    EXPECT_FALSE(tiles.lacksBlocks(kPerBlock));
    tiles.ask(0, middle, kPerBlock);
    EXPECT_EQ(tiles.blocksNeeded(0), 2);
    tiles.setBlockPasses(0, 2 * kPerBlock);
    tiles.ask(0, middle, kPerBlock);
    EXPECT_EQ(tiles.blocksNeeded(0), 2) << "there are no more";
    tiles.refuseBlock(0);
    EXPECT_EQ(tiles.blocksNeeded(0), 0);
    tiles.allowBlocks();
    EXPECT_EQ(tiles.blocksNeeded(0), 2);
    tiles.forget();
    EXPECT_EQ(tiles.blocksNeeded(0), 0) << "what there is to offer is not known yet";
}

TEST(TileProgressTest, KnowsSinceWhichFrameATileHasBeenBegun) {
    TileProgress tiles(64);
    const int tile = tiles.tileAt(5, {40.0F, 3.0F});
    EXPECT_EQ(tiles.region(tile).face, 5);
    EXPECT_EQ(tiles.region(tile).x, 32);
    EXPECT_EQ(tiles.region(tile).y, 0);
    EXPECT_FALSE(tiles.begunBefore(tile, 100)) << "it has had no pass";
    tiles.setFrame(7);
    tiles.setPasses(tile, 1);
    tiles.setFrame(9);
    tiles.setPasses(tile, 2);
    EXPECT_FALSE(tiles.begunBefore(tile, 7));
    EXPECT_TRUE(tiles.begunBefore(tile, 8));
    tiles.forget();
    EXPECT_FALSE(tiles.begunBefore(tile, 100));
}

} // namespace
} // namespace aolib
