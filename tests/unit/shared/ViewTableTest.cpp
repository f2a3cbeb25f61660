#include "backbone/ViewTable.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace aolib {
namespace {

constexpr ViewId kLeft{1};
constexpr ViewId kRight{2};

Viewpoint sightFrom(float x, const glm::ivec2& size = {160, 90}) {
    const glm::mat4 view = glm::translate(glm::mat4(1.0F), glm::vec3(-x, 0, 0));
    const glm::mat4 projection = glm::perspective(1.0F, 1.5F, 0.1F, 100.0F);
    return {*HostCamera::create(view, projection), size, {}};
}

class ViewTableTest : public testing::Test {
protected:
    ViewTable table{[] { return std::make_unique<ViewState>(); }};
};

TEST_F(ViewTableTest, IdsNameViews) {
    ViewState& left = table.begin(kLeft, sightFrom(0));
    ViewState& right = table.begin(kRight, sightFrom(0));
    EXPECT_NE(&left, &right);
    EXPECT_EQ(table.current(), &right);
    EXPECT_EQ(&table.begin(kLeft, sightFrom(1)), &left) << "its camera has moved";
    EXPECT_EQ(&table.begin(kLeft, sightFrom(1, {80, 45})), &left) << "its size has changed";
    EXPECT_EQ(table.find(kRight), &right);
    table.remove(kRight);
    EXPECT_EQ(table.find(kRight), nullptr);
    EXPECT_EQ(table.current(), &left);
    table.remove(kLeft);
    EXPECT_EQ(table.current(), nullptr);
}

TEST_F(ViewTableTest, CamerasThatTakeTurnsByOneIdAreViewsOfTheirOwn) {
    for (const int count : {2, 4, 7}) {
        table.remove(kLeft);
        for (int i = 0; i < 6 * count; ++i) {
            table.begin(kLeft, sightFrom(static_cast<float>(i % count)));
        }
        ASSERT_EQ(table.all().size(), static_cast<std::size_t>(count));
        const ViewState& one = table.begin(kLeft, sightFrom(0));
        EXPECT_NE(&table.begin(kLeft, sightFrom(1)), &one);
        EXPECT_EQ(&table.begin(kLeft, sightFrom(0)), &one);
    }
}

TEST_F(ViewTableTest, ACameraThatJittersIsOneView) {
    for (int i = 0; i < 40; ++i) {
        glm::mat4 projection = glm::perspective(1.0F, 1.5F, 0.1F, 100.0F);
        projection[2][0] = 0.001F * static_cast<float>(i % 4);
        table.begin(kLeft, {*HostCamera::create(glm::mat4(1.0F), projection), {160, 90}, {}});
    }
    EXPECT_EQ(table.all().size(), 1U);
}

TEST_F(ViewTableTest, ACameraThatWalksToAndFroIsOneView) {
    for (int i = 0; i < 80; ++i) {
        table.begin(kLeft, sightFrom(static_cast<float>(std::abs(i % 40 - 20))));
    }
    EXPECT_EQ(table.all().size(), 1U);
}

TEST_F(ViewTableTest, WhatNobodyDrawsIsGivenUp) {
    table.begin(kLeft, sightFrom(0));
    const ViewState& left = *table.current();
    for (std::uint64_t i = 0; i < ViewTable::kIdleFrames; ++i) {
        table.begin(kRight, sightFrom(0));
        EXPECT_EQ(table.isRecent(left), i < ViewTable::kRecentFrames);
    }
    ASSERT_EQ(table.all().size(), 2U);
    table.begin(kRight, sightFrom(0));
    EXPECT_EQ(table.all().size(), 1U);
}

TEST_F(ViewTableTest, ThereIsAMost) {
    for (std::uint32_t i = 0; i < 200; ++i) {
        table.begin(ViewId{i}, sightFrom(0));
        ASSERT_LE(table.all().size(), ViewTable::kMost);
        ASSERT_EQ(table.current(), table.find(ViewId{i}));
    }
    EXPECT_EQ(table.find(ViewId{0}), nullptr);
    EXPECT_NE(table.find(ViewId{199}), nullptr);
}

} // namespace
} // namespace aolib
