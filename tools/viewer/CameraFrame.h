#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "content/NamedCamera.h"

namespace aolib::viewer {

/// A camera's axes, unit length, in double precision so that many small steps add up.
struct CameraFrame {
    explicit CameraFrame(const NamedCamera& camera);

    /// `forward`, turned by angles in radians about `up` (to the right) and upwards, but not closer
    /// to the poles than a hundredth of a right angle.
    glm::dvec3 turned(const glm::dvec2& angles) const;

    glm::dvec3 forward; ///< from the eye to the target
    glm::dvec3 right;
    glm::dvec3 above;      ///< of the picture, perpendicular to the two others
    glm::dvec3 up;         ///< the camera's, where a walker's head is
    double distance = 1.0; ///< from the eye to the target, world units
};

} // namespace aolib::viewer
