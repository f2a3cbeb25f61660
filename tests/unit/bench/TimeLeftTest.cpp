#include "bench/TimeLeft.h"

#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

TEST(TimeLeft, ExpectsOfAMethodWhatItHasTaken) {
    TimeLeft left(3, 2);
    EXPECT_EQ(left.text(), "");
    left.done(0, 1.0);
    left.done(1, 9.0);
    EXPECT_DOUBLE_EQ(left.secondsLeft(), 20.0);
    EXPECT_DOUBLE_EQ(left.fraction(), 10.0 / 30.0);
    EXPECT_EQ(left.text(), "about 20 s left");
}

TEST(TimeLeft, ExpectsTheMeanOfAnUnseenMethod) {
    TimeLeft left(2, 2);
    left.done(0, 4.0);
    EXPECT_DOUBLE_EQ(left.secondsLeft(), 4.0 + 2 * 4.0);
}

TEST(TimeLeft, ForgetsSkippedCases) {
    TimeLeft left(3, 1);
    left.done(0, 100.0);
    left.skipCase();
    EXPECT_DOUBLE_EQ(left.secondsLeft(), 100.0);
    left.done(0, 100.0);
    EXPECT_DOUBLE_EQ(left.fraction(), 1.0);
}

TEST(TimeLeft, SpeaksInFittingUnits) {
    TimeLeft left(2, 1);
    left.done(0, 3900.0);
    EXPECT_EQ(left.text(), "about 1 h 5 min left");
}

} // namespace
} // namespace aolib::bench
