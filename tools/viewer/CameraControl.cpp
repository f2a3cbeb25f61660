#include "viewer/CameraControl.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "viewer/OrbitCamera.h"
#include "viewer/WalkCamera.h"

namespace aolib::viewer {

namespace {

/// How far beyond the farthest corner of the scene the far plane lies.
constexpr double kFarMargin = 1.05;
constexpr float kFast = 4.0F;
/// The factor of the walking speed for a notch of the wheel, and its bounds.
constexpr float kSpeedPerNotch = 1.25F;
constexpr float kSlowest = 0.001F;
constexpr float kFastest = 2.0F;
/// The longest time that counts as one step: a pause is no leap.
constexpr float kLongestStep = 0.25F;

} // namespace

void CameraControl::begin(const NamedCamera& camera, const Bounds& bounds, float size) {
    bounds_ = bounds;
    size_ = size;
    place(camera);
}

void CameraControl::place(const NamedCamera& camera) {
    home_ = camera;
    camera_ = camera;
}

bool CameraControl::follow(const Input& input, float height, float seconds, bool turning) {
    const NamedCamera before = camera_;
    if (mode == CameraMode::Orbit) {
        orbit(input, height, turning);
    } else {
        walk(input, height, std::min(seconds, kLongestStep), turning);
    }
    const bool moved = camera_.eye != before.eye || camera_.target != before.target;
    if (moved) {
        enclose();
    }
    return moved;
}

void CameraControl::orbit(const Input& input, float height, bool turning) {
    const OrbitCamera orbit(size_, height);
    if (turning) {
        orbit.turn(camera_, input.of(MouseButton::Left).by);
    }
    orbit.pan(camera_, input.of(MouseButton::Right).by + input.of(MouseButton::Middle).by);
    if (input.wheel != 0.0F) {
        orbit.zoom(camera_, input.wheel);
    }
}

void CameraControl::walk(const Input& input, float height, float seconds, bool turning) {
    const WalkCamera walk(size_, height);
    if (turning) {
        walk.look(camera_, input.of(MouseButton::Left).by);
    }
    walk.look(camera_, input.of(MouseButton::Right).by);
    walkSpeed = std::clamp(walkSpeed * std::pow(kSpeedPerNotch, input.wheel), kSlowest, kFastest);
    if (input.walk != glm::vec3(0.0F)) {
        walk.move(camera_, input.walk, input.fast ? kFast * walkSpeed : walkSpeed, seconds);
    }
}

/// The far plane follows the camera, so that the scene stays before it.
void CameraControl::enclose() {
    const glm::dvec3 eye(camera_.eye);
    const glm::dvec3 reach =
        glm::max(glm::abs(glm::dvec3(bounds_.min) - eye), glm::abs(glm::dvec3(bounds_.max) - eye));
    camera_.far = std::max(home_.far, static_cast<float>(kFarMargin * glm::length(reach)));
}

} // namespace aolib::viewer
