#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "content/Model.h"
#include "content/NamedCamera.h"

namespace aolib {

/// A floor of 16 by 16, a wall along its far side and two boxes: all coordinates whole numbers, so
/// that it can be scaled and moved far without any rounding. Open: it has a sky.
Model court();
/// Its view: along -z, no rotation, coordinates whole numbers.
NamedCamera courtCamera();

/// The model, every vertex times `factor`.
Model scaled(Model model, float factor);
/// The camera in a scene of that scale.
NamedCamera scaled(NamedCamera camera, float factor);
/// The model turned about the origin.
Model turned(Model model, const glm::mat3& rotation);
NamedCamera turned(NamedCamera camera, const glm::mat3& rotation);
/// The model moved, in its vertices or in its meshes' transforms.
Model moved(Model model, const glm::vec3& by, bool inTransforms);
NamedCamera moved(NamedCamera camera, const glm::vec3& by);

/// Upright boxes on a floor, 1 high, `thickness` thick and `spacing` apart.
Model fins(float thickness, float spacing);
/// Squares of this size, turned at random, scattered over a floor up to 1.5 high.
Model leaves(int count, float size);

} // namespace aolib
