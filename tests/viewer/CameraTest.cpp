#include <gtest/gtest.h>

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "viewer/CameraControl.h"
#include "viewer/OrbitCamera.h"
#include "viewer/WalkCamera.h"

namespace aolib::viewer {
namespace {

constexpr float kHeight = 600.0F;
constexpr float kSize = 10.0F;

NamedCamera someCamera() {
    NamedCamera camera;
    camera.eye = {3.0F, 2.0F, 4.0F};
    camera.target = {1.0F, 0.5F, -1.0F};
    camera.fovyDeg = 50.0F;
    return camera;
}

/// Where a point is seen, pixels from the middle, right and up.
glm::vec2 seen(const NamedCamera& camera, const glm::vec3& point) {
    const glm::vec4 clip =
        projectionMatrix(camera, 1.0F) * viewMatrix(camera) * glm::vec4(point, 1.0F);
    return 0.5F * kHeight * glm::vec2(clip) / clip.w;
}

double distanceToTarget(const NamedCamera& camera) {
    return glm::length(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
}

TEST(OrbitCameraTest, KeepsTargetAndDistance) {
    NamedCamera camera = someCamera();
    const NamedCamera before = camera;
    const OrbitCamera orbit(kSize, kHeight);
    for (int i = 0; i < 200; ++i) {
        orbit.turn(camera, {7.0F, (i % 2 == 0) ? 3.0F : -2.0F});
    }
    EXPECT_EQ(camera.target, before.target);
    EXPECT_NEAR(distanceToTarget(camera), distanceToTarget(before), 1e-4);
    EXPECT_GT(glm::distance(camera.eye, before.eye), 0.1F);
}

TEST(OrbitCameraTest, SceneFollowsTheMouse) {
    NamedCamera camera = someCamera();
    const glm::vec3 towardsTheEye = glm::mix(camera.target, camera.eye, 0.2F);
    OrbitCamera(kSize, kHeight).turn(camera, {20.0F, 0.0F});
    EXPECT_GT(seen(camera, towardsTheEye).x, 1.0F);
    camera = someCamera();
    OrbitCamera(kSize, kHeight).turn(camera, {0.0F, 20.0F}); // down
    EXPECT_LT(seen(camera, towardsTheEye).y, -1.0F);
}

TEST(OrbitCameraTest, StopsShortOfThePoles) {
    for (const float way : {-1.0F, 1.0F}) {
        NamedCamera camera = someCamera();
        OrbitCamera(kSize, kHeight).turn(camera, {0.0F, way * 5000.0F});
        const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
        EXPECT_LT(std::abs(forward.y), 0.9999F);
        EXPECT_GT(std::abs(forward.y), 0.99F);
        EXPECT_EQ(forward.y > 0.0F, way < 0.0F);
        // The heading is what it was: nothing has flipped over.
        const glm::vec3 before = someCamera().target - someCamera().eye;
        EXPECT_GT(forward.x * before.x + forward.z * before.z, 0.0F);
    }
}

TEST(OrbitCameraTest, PanKeepsTheTargetBelowTheMouse) {
    NamedCamera camera = someCamera();
    const glm::vec3 point = camera.target;
    OrbitCamera(kSize, kHeight).pan(camera, {30.0F, -12.0F});
    EXPECT_NEAR(seen(camera, point).x, 30.0F, 0.01F);
    EXPECT_NEAR(seen(camera, point).y, 12.0F, 0.01F);
    EXPECT_NEAR(distanceToTarget(camera), distanceToTarget(someCamera()), 1e-5);
}

TEST(OrbitCameraTest, ZoomGoesAlongTheLineOfSightWithinBounds) {
    NamedCamera camera = someCamera();
    const OrbitCamera orbit(kSize, kHeight);
    orbit.zoom(camera, 3.0F);
    EXPECT_LT(distanceToTarget(camera), distanceToTarget(someCamera()));
    const glm::vec3 now = glm::normalize(camera.target - camera.eye);
    EXPECT_NEAR(glm::dot(now, glm::normalize(someCamera().target - someCamera().eye)), 1.0F, 1e-6F);
    orbit.zoom(camera, -3.0F);
    EXPECT_NEAR(distanceToTarget(camera), distanceToTarget(someCamera()), 1e-4);
    orbit.zoom(camera, 1000.0F);
    EXPECT_GT(distanceToTarget(camera), 0.001 * static_cast<double>(kSize));
    orbit.zoom(camera, -1000.0F);
    EXPECT_LT(distanceToTarget(camera), 100.0 * static_cast<double>(kSize));
}

TEST(WalkCameraTest, LooksAroundWithoutMoving) {
    NamedCamera camera = someCamera();
    const glm::vec3 point = camera.target;
    WalkCamera(kSize, kHeight).look(camera, {25.0F, 10.0F});
    EXPECT_EQ(camera.eye, someCamera().eye);
    EXPECT_NEAR(distanceToTarget(camera), distanceToTarget(someCamera()), 1e-5);
    // What was in the middle has gone with the mouse, right and down.
    EXPECT_NEAR(seen(camera, point).x, 25.0F, 6.0F);
    EXPECT_NEAR(seen(camera, point).y, -10.0F, 3.0F);
}

TEST(WalkCameraTest, MovesByTheCamerasAxes) {
    NamedCamera camera = someCamera();
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    WalkCamera(kSize, kHeight).move(camera, {0.0F, 0.0F, 1.0F}, 0.1F, 0.5F);
    const glm::vec3 step = camera.eye - someCamera().eye;
    EXPECT_NEAR(glm::length(step), kSize * 0.1F * 0.5F, 1e-5F);
    EXPECT_NEAR(glm::dot(glm::normalize(step), forward), 1.0F, 1e-5F);
    EXPECT_NEAR(glm::distance(camera.target - camera.eye, someCamera().target - someCamera().eye),
                0.0F, 1e-5F);
    camera = someCamera();
    WalkCamera(kSize, kHeight).move(camera, {1.0F, 0.0F, 0.0F}, 0.1F, 0.5F);
    EXPECT_GT(glm::dot(camera.eye - someCamera().eye, glm::cross(forward, camera.up)), 0.0F);
    camera = someCamera();
    WalkCamera(kSize, kHeight).move(camera, {0.0F, 1.0F, 0.0F}, 0.1F, 0.5F);
    EXPECT_GT(camera.eye.y, someCamera().eye.y);
}

class CameraControlTest : public testing::Test {
protected:
    void SetUp() override {
        bounds.include(glm::vec3(-5.0F));
        bounds.include(glm::vec3(5.0F));
        control.begin(someCamera(), bounds, kSize);
    }
    bool follow(const Input& input, float seconds = 0.1F, bool turning = true) {
        return control.follow(input, kHeight, seconds, turning);
    }

    Bounds bounds;
    CameraControl control;
};

TEST_F(CameraControlTest, RestsWithoutInput) {
    for (const CameraMode mode : {CameraMode::Orbit, CameraMode::Walk}) {
        control.mode = mode;
        EXPECT_FALSE(follow({}));
        EXPECT_EQ(control.camera().eye, someCamera().eye);
        EXPECT_EQ(control.camera().target, someCamera().target);
    }
}

TEST_F(CameraControlTest, ADragThatIsNotItsOwnIsLeftAlone) {
    Input input;
    input.drags[0].by = {30.0F, 0.0F};
    EXPECT_FALSE(follow(input, 0.1F, /*turning=*/false));
    EXPECT_TRUE(follow(input));
    control.reset();
    EXPECT_EQ(control.camera().eye, someCamera().eye);
}

TEST_F(CameraControlTest, WheelZoomsOrChangesTheSpeed) {
    Input input;
    input.wheel = 2.0F;
    EXPECT_TRUE(follow(input));
    control.mode = CameraMode::Walk;
    EXPECT_FALSE(follow(input));
    EXPECT_GT(control.walkSpeed, CameraControl::kWalkSpeed);
}

TEST_F(CameraControlTest, WalksOnlyWhereOneWalksAndShiftIsFaster) {
    Input input;
    input.walk = {0.0F, 0.0F, 1.0F};
    EXPECT_FALSE(follow(input));
    control.mode = CameraMode::Walk;
    EXPECT_TRUE(follow(input));
    const float slow = glm::distance(control.camera().eye, someCamera().eye);
    control.reset();
    input.fast = true;
    follow(input);
    EXPECT_GT(glm::distance(control.camera().eye, someCamera().eye), 2.0F * slow);
}

TEST_F(CameraControlTest, APauseIsNoLeap) {
    control.mode = CameraMode::Walk;
    Input input;
    input.walk = {0.0F, 0.0F, 1.0F};
    follow(input, 3600.0F);
    EXPECT_LT(glm::distance(control.camera().eye, someCamera().eye), 0.1F * kSize);
}

TEST_F(CameraControlTest, FarPlaneStaysBehindTheScene) {
    Input input;
    input.wheel = -20.0F;
    follow(input);
    const glm::mat4 view = viewMatrix(control.camera());
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1U) != 0 ? 5.0F : -5.0F, (corner & 2U) != 0 ? 5.0F : -5.0F,
                          (corner & 4U) != 0 ? 5.0F : -5.0F);
        EXPECT_LT(-(view * glm::vec4(p, 1.0F)).z, control.camera().far);
    }
}

} // namespace
} // namespace aolib::viewer
