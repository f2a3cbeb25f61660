#include "bench/bake/BakeTable.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace aolib::bench {

namespace {

std::vector<BakeRow> rows() {
    return {
        {"big", 654480, BakeMethodName::Scatter, 512, 1024, 70.0, 90.0, {0.01, 0.03, 0.0, 1, 9}},
        {"small", 6036, BakeMethodName::Scatter, 512, 1024, 5.0, 6.0, {0.02, 0.04, 0.0, 1, 9}},
        {"small", 6036, BakeMethodName::Shadow, 100, 1024, 5.0, 7.0, {0.02, 0.04, 0.0, 1, 9}}};
}

TEST(BakeTableTest, RowsComeBackFromTheirText) {
    const std::vector<BakeRow> read = rowsOfBakeCsv(bakeCsv(rows()));
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[0].mesh, "big");
    EXPECT_EQ(read[2].method, BakeMethodName::Shadow);
    EXPECT_EQ(read[1].processor, 5.0);
    EXPECT_EQ(read[1].seconds, 6.0);
    EXPECT_EQ(read[1].errors.seams, 0.04);
}

TEST(BakeTableTest, ThePlotHasThePapersFiguresForItsNumbersOfDirections) {
    const Plot plot = bakePlot(rows(), "");
    ASSERT_EQ(plot.curves.size(), 4U);
    const Curve& scatter = plot.curves[0];
    EXPECT_EQ(scatter.points.front().x, 6036.0) << "by size";
    const auto paper = std::find_if(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) {
        return curve.name.find("McGraw and Sowers: shadow, 512") == 0;
    });
    ASSERT_NE(paper, plot.curves.end());
    EXPECT_EQ(paper->points.back().y, 40.5);
}

} // namespace

} // namespace aolib::bench
