#include <gtest/gtest.h>

#include "viewer/SplitLine.h"

namespace aolib::viewer {
namespace {

constexpr float kWidth = 1000.0F;

TEST(SplitLineTest, IsDraggedFromWhereItWasGrasped) {
    SplitLine line(0.5F);
    EXPECT_FALSE(line.follow(504.0F, kWidth, /*pressed=*/true, /*held=*/true));
    EXPECT_TRUE(line.dragging());
    EXPECT_TRUE(line.follow(604.0F, kWidth, false, true));
    EXPECT_FLOAT_EQ(line.share(), 0.6F);
    EXPECT_FALSE(line.follow(704.0F, kWidth, false, false));
    EXPECT_FALSE(line.dragging());
    EXPECT_FLOAT_EQ(line.share(), 0.6F);
}

TEST(SplitLineTest, APressElsewhereIsNotItsOwn) {
    SplitLine line(0.5F);
    line.follow(300.0F, kWidth, true, true);
    EXPECT_FALSE(line.dragging());
    EXPECT_FALSE(line.follow(500.0F, kWidth, false, true)); // drawn over it
    EXPECT_FLOAT_EQ(line.share(), 0.5F);
}

TEST(SplitLineTest, StaysWhereItCanBeGrasped) {
    SplitLine line(0.5F);
    line.follow(500.0F, kWidth, true, true);
    line.follow(-4000.0F, kWidth, false, true);
    EXPECT_GT(line.share(), 0.0F);
    line.follow(9000.0F, kWidth, false, true);
    EXPECT_LT(line.share(), 1.0F);
    EXPECT_GT(SplitLine(-3.0F).share(), 0.0F);
}

} // namespace
} // namespace aolib::viewer
