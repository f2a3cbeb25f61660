#include "bench/TriangleGrid.h"

#include <set>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

std::vector<glm::dvec2> gridPoints(const TriangleGrid& grid) {
    std::vector<glm::dvec2> points;
    for (std::uint32_t j = 0; j <= grid.splits; ++j) {
        for (std::uint32_t i = 0; i + j <= grid.splits; ++i) {
            points.emplace_back(double(i) / grid.splits, double(j) / grid.splits);
        }
    }
    return points;
}

TEST(TriangleGrid, NumbersItsPointsRowByRow) {
    for (std::uint32_t splits : {1U, 2U, 5U}) {
        const TriangleGrid grid{splits};
        std::size_t expected = 0;
        for (std::uint32_t j = 0; j <= splits; ++j) {
            for (std::uint32_t i = 0; i + j <= splits; ++i) {
                EXPECT_EQ(grid.index(i, j), expected++);
            }
        }
        EXPECT_EQ(grid.points(), expected);
    }
}

TEST(TriangleGrid, InterpolatesAnyPlaceExactly) {
    const TriangleGrid grid{7};
    const std::vector<glm::dvec2> points = gridPoints(grid);
    for (double u = 0.0; u <= 1.0; u += 0.03125) {
        for (double v = 0.0; u + v <= 1.0; v += 0.03125) {
            const TriangleGrid::Place place = grid.locate(u, v);
            glm::dvec2 sum(0.0);
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_LT(place.corners[k], points.size());
                EXPECT_GE(place.weights[k], -1e-12);
                sum += place.weights[k] * points[place.corners[k]];
            }
            EXPECT_NEAR(sum.x, u, 1e-12) << u << ' ' << v;
            EXPECT_NEAR(sum.y, v, 1e-12) << u << ' ' << v;
        }
    }
}

} // namespace
} // namespace aolib::bench
