#include "viewer/CameraFrame.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aolib::viewer {

namespace {

constexpr double kQuarterTurn = 1.5707963267948966;
constexpr double kSteepest = 0.99 * kQuarterTurn;

} // namespace

CameraFrame::CameraFrame(const NamedCamera& camera)
    : forward(glm::dvec3(camera.target) - glm::dvec3(camera.eye)),
      up(glm::normalize(glm::dvec3(camera.up))), distance(glm::length(forward)) {
    forward /= distance;
    right = glm::normalize(glm::cross(forward, up));
    above = glm::cross(right, forward);
}

glm::dvec3 CameraFrame::turned(const glm::dvec2& angles) const {
    const double elevation = std::asin(std::clamp(glm::dot(forward, up), -1.0, 1.0));
    // A camera that was given steeper than the limit stays where it is until it is turned back.
    const double limit = std::max(kSteepest, std::abs(elevation));
    const double steep = std::clamp(elevation + angles.y, -limit, limit);
    const glm::dvec3 level = glm::normalize(glm::cross(up, right));
    const glm::dvec3 heading = std::cos(angles.x) * level + std::sin(angles.x) * right;
    return std::cos(steep) * heading + std::sin(steep) * up;
}

} // namespace aolib::viewer
