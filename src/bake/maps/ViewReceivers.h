#pragma once

#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include <aolib/Status.h>
#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/ViewPixels.h>

#include "bake/geometry/BakeGeometry.h"

namespace aolib::bake {

/// The receivers of a view, of those pixels that show something, in their order. Errors:
/// InvalidOption (sizes), InvalidPosition, InvalidNormal.
Result<std::vector<SurfacePoint>> findReceivers(const ViewPixels& view);

/// The view as a picture.
/// @param values  of the receivers, in their order: W, and the direction as xyz in the last three.
BakedMap makePicture(const ViewPixels& view, std::span<const glm::vec4> values);

} // namespace aolib::bake
