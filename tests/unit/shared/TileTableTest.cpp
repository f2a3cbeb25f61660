#include "backbone/cubemaps/TileTable.h"

#include <set>

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(TileTableTest, TilesCoverEveryTexelOnce) {
    for (const int size : {16, 32, 100, 512}) {
        const TileTable tiles(size);
        std::set<std::tuple<int, int, int>> texels;
        for (int tile = 0; tile < tiles.count(); ++tile) {
            const TileTable::Region region = tiles.region(tile);
            for (int y = 0; y < region.height; ++y) {
                for (int x = 0; x < region.width; ++x) {
                    EXPECT_TRUE(texels.insert({region.face, region.x + x, region.y + y}).second);
                }
            }
        }
        EXPECT_EQ(texels.size(), static_cast<std::size_t>(kFaces * size * size));
    }
}

TEST(TileTableTest, OnlyRequestedTilesAreUrgent) {
    TileTable tiles(128);
    EXPECT_EQ(tiles.fewestPasses(), -1);
    EXPECT_FALSE(tiles.hasPending(1)) << "nothing is requested, nothing is pending";
    tiles.request(2, {48.0F, 80.0F});
    ASSERT_EQ(tiles.mostUrgent(4).size(), 1U) << "the middle of a tile";
    const TileTable::Region region = tiles.region(tiles.mostUrgent(4)[0]);
    EXPECT_EQ(region.face, 2);
    EXPECT_EQ(region.x, 32);
    EXPECT_EQ(region.y, 64);
    tiles.request(2, {65.0F, 80.0F});
    EXPECT_EQ(tiles.mostUrgent(4).size(), 2U)
        << "beside a border, both tiles; one is requested already";
    tiles.request(5, {0.0F, 128.0F});
    EXPECT_EQ(tiles.mostUrgent(4).size(), 3U) << "a face's corner is no overrun";
}

TEST(TileTableTest, ThePoorestComeFirst) {
    TileTable tiles(64);
    tiles.requestAll();
    EXPECT_EQ(tiles.mostUrgent(2).size(), static_cast<std::size_t>(tiles.count()));
    for (int tile = 0; tile < tiles.count(); ++tile) {
        tiles.setPasses(tile, tile == 3 ? 0 : 1);
    }
    EXPECT_EQ(tiles.mostUrgent(2), std::vector<int>{3});
    tiles.setPasses(3, 1);
    EXPECT_TRUE(tiles.hasPending(2));
    EXPECT_FALSE(tiles.hasPending(1));
    EXPECT_TRUE(tiles.mostUrgent(1).empty());
    tiles.forget();
    EXPECT_EQ(tiles.fewestPasses(), 0);
    EXPECT_TRUE(tiles.isRequested(0)) << "what was requested stays";
}

TEST(TileTableTest, PagesAreRequestedOneAfterTheOther) {
    constexpr int kPerPage = 4;
    TileTable tiles(64);
    const glm::vec2 middle(16.0F, 16.0F);
    tiles.request(0, middle);
    EXPECT_EQ(tiles.pagesNeeded(0), 0) << "no view requests it";
    tiles.request(0, middle, kPerPage);
    EXPECT_EQ(tiles.pagesNeeded(0), 0) << "none is available";
    tiles.setAvailablePages(0, 2);
    EXPECT_EQ(tiles.pagesNeeded(0), 1);
    EXPECT_TRUE(tiles.hasPendingPages(kPerPage));
    tiles.setPagePasses(0, kPerPage - 1);
    tiles.request(0, middle, kPerPage);
    EXPECT_EQ(tiles.pagesNeeded(0), 1) << "one is on its way";
    EXPECT_EQ(tiles.share(8, 3).needed, 8 + 3 * 8);
    EXPECT_EQ(tiles.share(8, 3).done, 3 * (kPerPage - 1));
    tiles.setPagePasses(0, kPerPage);
    EXPECT_FALSE(tiles.hasPendingPages(kPerPage));
    tiles.request(0, middle, kPerPage);
    EXPECT_EQ(tiles.pagesNeeded(0), 2);
    tiles.setPagePasses(0, 2 * kPerPage);
    tiles.request(0, middle, kPerPage);
    EXPECT_EQ(tiles.pagesNeeded(0), 2) << "there are no more";
    tiles.denyPages(0);
    EXPECT_EQ(tiles.pagesNeeded(0), 0);
    tiles.clearDeniedPages();
    EXPECT_EQ(tiles.pagesNeeded(0), 2);
    tiles.forget();
    EXPECT_EQ(tiles.pagesNeeded(0), 0) << "what is available is not known yet";
}

TEST(TileTableTest, KnowsSinceWhichFrameATileHasBeenBegun) {
    TileTable tiles(64);
    const int tile = tiles.tileAt(5, {40.0F, 3.0F});
    EXPECT_EQ(tiles.region(tile).face, 5);
    EXPECT_EQ(tiles.region(tile).x, 32);
    EXPECT_EQ(tiles.region(tile).y, 0);
    EXPECT_FALSE(tiles.isKnownSince(tile, 100)) << "it has had no pass";
    tiles.setFrame(7);
    tiles.setPasses(tile, 1);
    tiles.setFrame(9);
    tiles.setPasses(tile, 2);
    EXPECT_FALSE(tiles.isKnownSince(tile, 6));
    EXPECT_TRUE(tiles.isKnownSince(tile, 7));
    tiles.forget();
    EXPECT_FALSE(tiles.isKnownSince(tile, 100));
}

} // namespace
} // namespace aolib
