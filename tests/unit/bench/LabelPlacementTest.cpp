#include "bench/plot/LabelPlacement.h"

#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

bool overlap(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

const Box kArea{{0.0, 0.0}, {200.0, 100.0}};
constexpr glm::dvec2 kLabel{40.0, 10.0};

TEST(LabelPlacement, KeepsNeighboursApart) {
    LabelPlacement labels(kArea);
    std::vector<Box> boxes;
    for (const double x : {100.0, 104.0, 108.0}) {
        labels.block({{x - 4.0, 46.0}, {x + 4.0, 54.0}});
    }
    for (const double x : {100.0, 104.0, 108.0}) {
        boxes.push_back(labels.place({x, 50.0}, 4.0, kLabel));
    }
    EXPECT_FALSE(overlap(boxes[0], boxes[1]));
    EXPECT_FALSE(overlap(boxes[1], boxes[2]));
    EXPECT_FALSE(overlap(boxes[0], boxes[2]));
}

TEST(LabelPlacement, StaysInside) {
    LabelPlacement labels(kArea);
    for (const glm::dvec2 corner : {glm::dvec2(198, 2), {2, 2}, {198, 98}, {2, 98}}) {
        const Box box = labels.place(corner, 4.0, kLabel);
        EXPECT_GE(box.low.x, 0.0);
        EXPECT_GE(box.low.y, 0.0);
        EXPECT_LE(box.high.x, 200.0);
        EXPECT_LE(box.high.y, 100.0);
    }
}

TEST(LabelPlacement, AvoidsLines) {
    LabelPlacement labels(kArea);
    labels.blockLine({{100.0, 50.0}, {200.0, 40.0}});
    labels.blockLine({{100.0, 50.0}, {200.0, 60.0}});
    const Box box = labels.place({100.0, 50.0}, 4.0, kLabel);
    EXPECT_LT(box.low.x, 100.0) << "the label lies on the lines to the right";
}

} // namespace
} // namespace aolib::bench
