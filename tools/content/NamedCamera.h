#pragma once

#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// A perspective view with a name. Lengths in world units.
struct NamedCamera {
    std::string name;
    glm::vec3 eye{0.0F};
    glm::vec3 target{0.0F, 0.0F, -1.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F}; ///< not parallel to target - eye
    float fovyDeg = 45.0F;          ///< vertical, degrees, in (0, 180)
    float near = 0.1F;
    float far = 100.0F;
};

/// World to eye.
glm::mat4 viewMatrix(const NamedCamera& camera);
/// Eye to clip, depth -1 to 1. `aspect` is width / height.
glm::mat4 projectionMatrix(const NamedCamera& camera, float aspect);

} // namespace aolib
