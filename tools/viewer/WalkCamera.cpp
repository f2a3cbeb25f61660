#include "viewer/WalkCamera.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "viewer/CameraFrame.h"

namespace aolib::viewer {

void WalkCamera::look(NamedCamera& camera, const glm::vec2& pixels) const {
    if (pixels == glm::vec2(0.0F)) {
        return; // not even by rounding
    }
    const CameraFrame frame(camera);
    const double radiansPerPixel =
        glm::radians(static_cast<double>(camera.fovyDeg)) / static_cast<double>(height_);
    const glm::dvec2 angles = glm::dvec2(pixels) * radiansPerPixel;
    const glm::dvec3 forward = frame.turned({-angles.x, angles.y});
    camera.target = glm::vec3(glm::dvec3(camera.eye) + frame.distance * forward);
}

void WalkCamera::move(NamedCamera& camera, const glm::vec3& direction, float speed,
                      float seconds) const {
    const CameraFrame frame(camera);
    const glm::dvec3 along(direction);
    const glm::dvec3 step = static_cast<double>(size_ * speed * seconds) *
                            (along.x * frame.right + along.y * frame.up + along.z * frame.forward);
    camera.eye = glm::vec3(glm::dvec3(camera.eye) + step);
    camera.target = glm::vec3(glm::dvec3(camera.target) + step);
}

} // namespace aolib::viewer
