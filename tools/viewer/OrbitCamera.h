#pragma once

#include <glm/vec2.hpp>

#include "content/NamedCamera.h"

namespace aolib::viewer {

/// Turns a camera about its target. Pixels are of the mouse: right and down are positive.
class OrbitCamera {
public:
    /// @param sceneSize    the scene's diagonal, world units: bounds how far a zoom goes.
    /// @param sceneHeight  of the picture, mouse pixels.
    OrbitCamera(float sceneSize, float sceneHeight) : size_(sceneSize), height_(sceneHeight) {}

    /// As if the mouse had hold of the scene. Stops short of the poles.
    void turn(NamedCamera& camera, const glm::vec2& pixels) const;
    /// Moves eye and target, so that what is at the target stays below the mouse.
    void pan(NamedCamera& camera, const glm::vec2& pixels) const;
    /// Goes nearer to the target (notches above 0) or away from it.
    void zoom(NamedCamera& camera, float notches) const;

private:
    float size_;
    float height_;
};

} // namespace aolib::viewer
