#include "bench/Spread.h"

#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

TEST(Spread, HasTheQuartilesOfUnsortedValues) {
    const Spread spread = spreadOf({5.0, 1.0, 4.0, 2.0, 3.0});
    EXPECT_DOUBLE_EQ(spread.low, 2.0);
    EXPECT_DOUBLE_EQ(spread.median, 3.0);
    EXPECT_DOUBLE_EQ(spread.high, 4.0);
    EXPECT_EQ(spread.count, 5U);
}

TEST(Spread, LiesBetweenTheValuesOfAnEvenNumber) {
    const Spread spread = spreadOf({4.0, 1.0});
    EXPECT_DOUBLE_EQ(spread.median, 2.5);
    EXPECT_DOUBLE_EQ(spread.low, 1.75);
}

TEST(Spread, OfNothingIsUnknown) {
    EXPECT_LT(spreadOf({}).median, 0.0);
}

} // namespace
} // namespace aolib::bench
