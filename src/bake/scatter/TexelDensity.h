#pragma once

#include <glm/vec2.hpp>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"

namespace aolib::bake {

/// How finely maps show surfaces: texels along a frame unit, in the direction in which charts are
/// stretched most, that `share` of the charts' area in the maps does not exceed. 0 where no
/// triangle has usable UVs.
/// @param mapSize  texels.
double texelsAlongUnit(const BakeGeometry& geometry, const BakeFrame& frame,
                       const glm::dvec2& mapSize, double share);

} // namespace aolib::bake
