#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "viewer/CameraFrame.h"
#include "viewer/GizmoDrag.h"

namespace aolib::viewer {
namespace {

constexpr CubeMapId kId{7};
const glm::vec2 kWhole{800.0F, 600.0F};
const glm::vec3 kStart{1.0F, -0.5F, 2.0F};

NamedCamera dragCamera() {
    NamedCamera camera;
    camera.eye = {3.0F, 4.0F, 10.0F};
    camera.target = {0.0F, 1.0F, 0.0F};
    return camera;
}

glm::vec2 seenAt(const glm::vec3& position) {
    const glm::vec4 clip = projectionMatrix(dragCamera(), kWhole.x / kWhole.y) *
                           viewMatrix(dragCamera()) * glm::vec4(position, 1.0F);
    return (0.5F + glm::vec2(0.5F, -0.5F) * glm::vec2(clip) / clip.w) * kWhole;
}

double depthOf(const glm::vec3& position) {
    return glm::dot(glm::dvec3(position) - glm::dvec3(dragCamera().eye),
                    CameraFrame(dragCamera()).forward);
}

/// A drag by so many pixels, in steps.
std::optional<GizmoDrag::Move> dragged(const glm::vec2& by, GizmoDrag::Along along) {
    constexpr int kSteps = 10;
    const glm::vec2 mouse = seenAt(kStart) + glm::vec2(4.0F, -3.0F); // not on its middle
    GizmoDrag drag;
    drag.begin(kId, kStart, mouse);
    for (int i = 1; i <= kSteps; ++i) {
        drag.follow(mouse + by * (static_cast<float>(i) / kSteps), along, dragCamera(), kWhole);
    }
    return drag.end();
}

TEST(GizmoDragTest, StaysBelowTheMouseAsFarBeforeTheEye) {
    const glm::vec2 by(120.0F, -70.0F);
    const auto move = dragged(by, GizmoDrag::Along::Plane);
    ASSERT_TRUE(move);
    EXPECT_EQ(move->id, kId);
    EXPECT_NEAR(glm::distance(seenAt(move->to), seenAt(kStart) + by), 0.0F, 0.02F);
    EXPECT_NEAR(depthOf(move->to), depthOf(kStart), 1e-4);
}

TEST(GizmoDragTest, AlongTheRayUpIsFartherAndDownIsNearer) {
    const auto farther = dragged({40.0F, -100.0F}, GizmoDrag::Along::Ray);
    const auto nearer = dragged({0.0F, 100.0F}, GizmoDrag::Along::Ray);
    ASSERT_TRUE(farther && nearer);
    EXPECT_NEAR(glm::distance(seenAt(farther->to), seenAt(kStart)), 0.0F, 0.02F);
    EXPECT_NEAR(depthOf(farther->to) / depthOf(kStart), std::exp(0.5), 1e-3);
    EXPECT_NEAR(depthOf(nearer->to) / depthOf(kStart), std::exp(-0.5), 1e-3);
}

TEST(GizmoDragTest, AClickMovesNothing) {
    EXPECT_FALSE(dragged({2.0F, 1.0F}, GizmoDrag::Along::Plane));
}

TEST(GizmoDragTest, WhatIsCancelledStaysWhereItWas) {
    GizmoDrag drag;
    drag.begin(kId, kStart, {100.0F, 100.0F});
    drag.follow({200.0F, 100.0F}, GizmoDrag::Along::Plane, dragCamera(), kWhole);
    ASSERT_TRUE(drag.current());
    EXPECT_NE(drag.current()->to, kStart);
    EXPECT_EQ(drag.from(), kStart);
    drag.cancel();
    EXPECT_FALSE(drag.current());
    drag.follow({300.0F, 100.0F}, GizmoDrag::Along::Plane, dragCamera(), kWhole);
    EXPECT_FALSE(drag.current());
    EXPECT_FALSE(drag.end());
}

} // namespace
} // namespace aolib::viewer
