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
    /// Whether a new cube map is due at the camera: there is none, or too little of what was drawn
    /// is shaded and none stands so close already that another would see the same.
    /// @param coverage   latest count, or nothing if none belongs to the cube maps as they are.
    /// @param threshold  share of shaded pixels that is enough.
    static bool due(std::optional<float> coverage, float threshold, const glm::vec3& camera,
                    std::span<const glm::vec3> cubeMaps, float sceneSize);

    /// Where a camera looks from, as far as cube maps are concerned: the eye of a perspective one.
    /// Parallel lines of sight have no eye: there it is a place before what the view
    /// shows of the scene, as far away as texels are still fine enough, since the farther the more
    /// of what the view sees is seen from there; and no nearer than where it fills a right angle.
    /// Where the near plane cuts the scene it is on that plane.
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
