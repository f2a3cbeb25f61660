#pragma once

#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "backbone/frame/Frame.h"
#include "scene/Scene.h"

namespace aolib {

/// Decides where cube maps go (thesis 4.6). No GL.
class Placement {
public:
    /// Whether a new cube map is needed at the camera: there is none, or the coverage is too low.
    /// Not needed if an existing cube map is so close that a new one would see the same surfaces.
    /// @param coverage   latest count, or none if no count belongs to the current cube maps.
    /// @param threshold  share of shaded pixels that is enough.
    static bool due(std::optional<float> coverage, float threshold, const glm::vec3& camera,
                    std::span<const glm::vec3> cubeMaps, float sceneSize);

    /// Returns the place of a cube map for a camera, world units: the eye of a perspective camera.
    /// For an orthographic camera: a place in front of the visible part of the scene. It is as far
    /// away as texels stay fine enough, since a farther place sees more of that part, and at least
    /// as far as where that part fills a right angle.
    /// If the near plane cuts the scene, the place lies on the near plane.
    /// @param scene     its bounds
    /// @param faceSize  of cube maps, texels
    static glm::vec3 standpoint(const Frame& frame, const Bounds& scene, int faceSize);
    /// The place as deep as `standpoint` in an orthographic view that looks straight at a point.
    static glm::vec3 across(const HostCamera& camera, const glm::vec3& standpoint,
                            const glm::vec3& point);

    /// The nearest position to `wanted` at which a cube map keeps off every surface.
    static glm::vec3 freePosition(const Scene& scene, const glm::vec3& wanted);
};

} // namespace aolib
