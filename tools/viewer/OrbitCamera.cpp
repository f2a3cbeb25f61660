#include "viewer/OrbitCamera.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "viewer/CameraFrame.h"

namespace aolib::viewer {

namespace {

/// Radians for the picture's height.
constexpr double kTurnPerHeight = 3.0;
/// The distance's factor for a notch of the wheel.
constexpr double kZoomPerNotch = 0.88;
/// The nearest and the farthest that a zoom goes, shares of the scene's diagonal.
constexpr double kNearest = 0.002;
constexpr double kFarthest = 20.0;

} // namespace

void OrbitCamera::turn(NamedCamera& camera, const glm::vec2& pixels) const {
    if (pixels == glm::vec2(0.0F)) {
        return; // not even by rounding
    }
    const CameraFrame frame(camera);
    const glm::dvec2 angles = glm::dvec2(pixels) * kTurnPerHeight / static_cast<double>(height_);
    // The scene follows the mouse, so the camera goes the other way round it.
    const glm::dvec3 forward = frame.turned({angles.x, -angles.y});
    camera.eye = glm::vec3(glm::dvec3(camera.target) - frame.distance * forward);
}

void OrbitCamera::pan(NamedCamera& camera, const glm::vec2& pixels) const {
    if (pixels == glm::vec2(0.0F)) {
        return; // not even by rounding
    }
    const CameraFrame frame(camera);
    const double slope = std::tan(0.5 * glm::radians(static_cast<double>(camera.fovyDeg)));
    const double perPixel = 2.0 * slope * frame.distance / static_cast<double>(height_);
    const glm::dvec3 step = perPixel * (static_cast<double>(pixels.y) * frame.above -
                                        static_cast<double>(pixels.x) * frame.right);
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + step);
    camera.target = glm::vec3(glm::dvec3(camera.target) + step);
}

void OrbitCamera::zoom(NamedCamera& camera, float notches) const {
    const CameraFrame frame(camera);
    const auto size = static_cast<double>(size_);
    const double wanted = frame.distance * std::pow(kZoomPerNotch, static_cast<double>(notches));
    const double distance = std::clamp(wanted, kNearest * size, kFarthest * size);
    camera.eye = glm::vec3(glm::dvec3(camera.target) - distance * frame.forward);
}

} // namespace aolib::viewer
