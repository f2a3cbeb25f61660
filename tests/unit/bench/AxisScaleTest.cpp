#include "bench/plot/AxisScale.h"

#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

TEST(AxisScale, PutsEveryValueInside) {
    const AxisScale logarithmic({0.003, 0.4, -1.0, 0.0}, true);
    for (const double value : {0.003, 0.4}) {
        EXPECT_GT(logarithmic.place(value), 0.0);
        EXPECT_LT(logarithmic.place(value), 1.0);
    }
    EXPECT_FALSE(logarithmic.shows(0.0));
    const AxisScale linear({5.0, 25.0}, false);
    EXPECT_DOUBLE_EQ(linear.place(0.0), 0.0);
    EXPECT_LT(linear.place(25.0), 1.0);
}

TEST(AxisScale, SpacesDecadesEvenly) {
    const AxisScale scale({1.0, 100.0}, true);
    EXPECT_NEAR(scale.place(10.0) - scale.place(1.0), scale.place(100.0) - scale.place(10.0),
                1e-12);
}

TEST(AxisScale, NamesAtLeastTwoTicksAndNotTooMany) {
    for (const auto& [low, high] : {std::pair{0.01, 0.011}, {0.01, 0.3}, {1.0, 50000.0}}) {
        int named = 0;
        for (const Tick& tick : AxisScale({low, high}, true).ticks()) {
            EXPECT_GE(AxisScale({low, high}, true).place(tick.value), 0.0);
            EXPECT_LE(AxisScale({low, high}, true).place(tick.value), 1.0);
            named += tick.text.empty() ? 0 : 1;
        }
        EXPECT_GE(named, 2) << low;
        EXPECT_LE(named, 12) << low;
    }
    const std::vector<Tick> linear = AxisScale({390.0}, false).ticks();
    EXPECT_GE(linear.size(), 4U);
    EXPECT_LE(linear.size(), 8U);
    EXPECT_EQ(linear.front().text, "0");
}

TEST(AxisScale, StandsWithoutValues) {
    EXPECT_FALSE(AxisScale({}, true).ticks().empty());
    EXPECT_FALSE(AxisScale({}, false).ticks().empty());
}

} // namespace
} // namespace aolib::bench
