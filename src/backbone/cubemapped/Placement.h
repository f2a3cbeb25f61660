#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "scene/Scene.h"

namespace aolib {

/// Decides where cube maps go (thesis 4.6). No GL.
class Placement {
public:
    /// Whether a new cube map is due at the camera: there is none, or too little of what was drawn
    /// is shaded and none stands so close already that another would see the same.
    /// @param coverage   latest count, or nothing if none belongs to the cube maps as they are.
    /// @param threshold  share of shaded pixels that is enough.
    static bool due(std::optional<float> coverage, float threshold, const glm::vec3& camera,
                    std::span<const glm::vec3> cubeMaps, float sceneSize);

    /// The nearest position to `wanted` at which a cube map keeps off every surface.
    static glm::vec3 freePosition(const Scene& scene, const glm::vec3& wanted);
};

} // namespace aolib
