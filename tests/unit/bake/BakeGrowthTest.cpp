#include "bench/bake/BakeGrowth.h"

#include <gtest/gtest.h>

namespace aolib::bench {

namespace {

BakeRow row(int samples, double processor, BakeMethodName method = BakeMethodName::Shadow) {
    return {"bumps", 6036, method, samples, 512, processor, processor, {}};
}

TEST(BakeGrowthTest, WhatIsDoneOnceIsToldFromWhatGrows) {
    // Out of order, and a method of which too little is known.
    const auto growths =
        growthOf({row(1024, 11.24), row(256, 3.56), row(512, 6.12),
                  row(256, 1.0, BakeMethodName::Rays), row(512, 2.0, BakeMethodName::Rays)});
    ASSERT_EQ(growths.size(), 1U);
    EXPECT_NEAR(growths[0].once, 1.0, 1e-9);
    EXPECT_NEAR(growths[0].perSample, 0.01, 1e-9);
    ASSERT_EQ(growths[0].points.size(), 3U);
    EXPECT_EQ(growths[0].points[0].samples, 256);
    EXPECT_NEAR(growths[0].points[2].growing, 10.24, 1e-9);
    const std::string table = growthMarkdown(growths);
    EXPECT_NE(table.find("| bumps | 512^2 | shadow | 1.00 s | 1.00 s | 256 to 512: 1.72, 512 to "
                         "1024: 1.84 | 2.00, 2.00 |"),
              std::string::npos)
        << table;
}

TEST(BakeGrowthTest, WhatGrowsFasterThanItsSamplesShows) {
    const auto growths = growthOf({row(256, 1.0), row(512, 3.0), row(1024, 9.0)});
    ASSERT_EQ(growths.size(), 1U);
    EXPECT_GT(growths[0].points[2].growing / growths[0].points[1].growing, 2.2);
    EXPECT_EQ(growthMarkdown({}), "");
}

} // namespace

} // namespace aolib::bench
