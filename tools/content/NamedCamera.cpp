#include "content/NamedCamera.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace aolib {

glm::mat4 viewMatrix(const NamedCamera& camera) {
    return glm::lookAt(camera.eye, camera.target, camera.up);
}

glm::mat4 projectionMatrix(const NamedCamera& camera, float aspect) {
    return glm::perspectiveRH_NO(glm::radians(camera.fovyDeg), aspect, camera.near, camera.far);
}

} // namespace aolib
