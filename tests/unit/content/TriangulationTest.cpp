#include "content/generated/Triangulation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "content/generated/SolidBuilder.h"

namespace aolib {
namespace {

double area(const Outline& outline) {
    double sum = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec2 a(outline[i]);
        const glm::dvec2 b(outline[(i + 1) % outline.size()]);
        sum += 0.5 * (a.x * b.y - a.y * b.x);
    }
    return sum;
}

/// Every triangle turns the right way, their areas add up, and there are as many as there must be.
void expectCovers(const Outline& outline, const std::vector<Outline>& holes) {
    Outline points = outline;
    double expected = area(outline);
    for (const Outline& hole : holes) {
        points.insert(points.end(), hole.begin(), hole.end());
        expected -= std::abs(area(hole));
    }
    const auto triangles = triangulate(outline, holes);
    double sum = 0.0;
    for (const auto& corners : triangles) {
        const double one = area({points[corners[0]], points[corners[1]], points[corners[2]]});
        EXPECT_GT(one, 0.0);
        sum += one;
    }
    EXPECT_EQ(triangles.size(), points.size() + 2 * holes.size() - 2);
    EXPECT_NEAR(sum, expected, 1e-4 * expected);
}

TEST(TriangulationTest, CoversConvexAndHollowOutlines) {
    expectCovers(rectangle({0, 0}, {2, 1}), {});
    expectCovers(regularPolygon(1.0F, 17), {});
    expectCovers({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, {});
}

TEST(TriangulationTest, CoversRowsOfWindows) {
    std::vector<Outline> windows;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 5; ++column) {
            const glm::vec2 low{1.0F + 2.0F * static_cast<float>(column),
                                1.0F + 2.0F * static_cast<float>(row)};
            windows.push_back(rectangle(low, low + 1.0F));
        }
    }
    expectCovers(rectangle({0, 0}, {11, 9}), windows);
}

TEST(TriangulationTest, CoversArches) {
    expectCovers(rectangle({-6, 0}, {6, 6}),
                 {roundArch({-5, 0.5F}, {-2, 5}, 12), pointedArch({-1, 1}, 2, 3, 5),
                  roundArch({2, 0.5F}, {5, 5}, 12)});
}

TEST(TriangulationTest, BridgesOnlyToWhatAHoleSees) {
    // The corner nearest to the hole is the tip of a spike behind a thin wall.
    expectCovers({{0, 0},
                  {10, 0},
                  {10, 4},
                  {1, 4},
                  {1, 4.1F},
                  {10, 4.1F},
                  {10, 10},
                  {6, 10},
                  {5.5F, 4.3F},
                  {5, 10},
                  {0, 10}},
                 {rectangle({5, 3}, {6, 3.8F})});
}

TEST(TriangulationTest, TakesHolesOfEitherWinding) {
    Outline hole = rectangle({1, 1}, {2, 2});
    expectCovers(rectangle({0, 0}, {3, 3}), {hole});
    std::reverse(hole.begin(), hole.end());
    expectCovers(rectangle({0, 0}, {3, 3}), {hole});
}

} // namespace
} // namespace aolib
