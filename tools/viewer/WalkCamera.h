#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "content/NamedCamera.h"

namespace aolib::viewer {

/// Moves a camera through a scene as one walks or flies. The target stays as far ahead as it was.
class WalkCamera {
public:
    /// @param sceneSize    the scene's diagonal, world units: a step's measure.
    /// @param sceneHeight  of the picture, mouse pixels.
    WalkCamera(float sceneSize, float sceneHeight) : size_(sceneSize), height_(sceneHeight) {}

    /// Turns the head: what is below the mouse follows it.
    void look(NamedCamera& camera, const glm::vec2& pixels) const;
    /// @param direction  to the right, up, and ahead, each -1 to 1; ahead is where the camera
    /// looks.
    /// @param speed      of one walk, scene diagonals per second.
    void move(NamedCamera& camera, const glm::vec3& direction, float speed, float seconds) const;

private:
    float size_;
    float height_;
};

} // namespace aolib::viewer
