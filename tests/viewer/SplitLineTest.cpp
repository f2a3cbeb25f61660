#include <gtest/gtest.h>

#include "viewer/SplitLine.h"

namespace aolib::viewer {
namespace {

constexpr float kWidth = 1000.0F;

/// The button went down at one place and is held at another.
ButtonDrag press(float from, float to) {
    return {/*pressed=*/true, /*held=*/true, {from, 0.0F}, {to, 0.0F}, {to - from, 0.0F}};
}

ButtonDrag hold(float to) {
    return {/*pressed=*/false, /*held=*/true, {}, {to, 0.0F}, {}};
}

ButtonDrag release(float to) {
    return {/*pressed=*/false, /*held=*/false, {}, {to, 0.0F}, {}};
}

TEST(SplitLineTest, IsDraggedFromWhereItWasGrasped) {
    SplitLine line(0.5F);
    EXPECT_FALSE(line.follow(press(504.0F, 504.0F), kWidth));
    EXPECT_TRUE(line.dragging());
    EXPECT_TRUE(line.follow(hold(604.0F), kWidth));
    EXPECT_FLOAT_EQ(line.share(), 0.6F);
    EXPECT_TRUE(line.follow(release(704.0F), kWidth));
    EXPECT_FLOAT_EQ(line.share(), 0.7F);
    EXPECT_FALSE(line.follow(release(804.0F), kWidth));
    EXPECT_FALSE(line.dragging());
    EXPECT_FLOAT_EQ(line.share(), 0.7F);
}

TEST(SplitLineTest, AFrameMaySeeAllOfADrag) {
    SplitLine line(0.5F);
    ButtonDrag flick = press(504.0F, 604.0F);
    flick.held = false;
    EXPECT_TRUE(line.follow(flick, kWidth));
    EXPECT_TRUE(line.dragging()) << "the camera is to leave it alone";
    EXPECT_FLOAT_EQ(line.share(), 0.6F);
    EXPECT_FALSE(line.follow(release(704.0F), kWidth));
    EXPECT_FALSE(line.dragging());
}

TEST(SplitLineTest, APressElsewhereIsNotItsOwn) {
    SplitLine line(0.5F);
    line.follow(press(300.0F, 300.0F), kWidth);
    EXPECT_FALSE(line.dragging());
    EXPECT_FALSE(line.follow(hold(500.0F), kWidth)); // drawn over it
    EXPECT_FLOAT_EQ(line.share(), 0.5F);
}

TEST(SplitLineTest, StaysWhereItCanBeGrasped) {
    SplitLine line(0.5F);
    line.follow(press(500.0F, 500.0F), kWidth);
    line.follow(hold(-4000.0F), kWidth);
    EXPECT_GT(line.share(), 0.0F);
    line.follow(hold(9000.0F), kWidth);
    EXPECT_LT(line.share(), 1.0F);
    EXPECT_GT(SplitLine(-3.0F).share(), 0.0F);
}

} // namespace
} // namespace aolib::viewer
