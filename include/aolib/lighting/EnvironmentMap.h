#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/Status.h>

namespace aolib::lighting {

/// Distant light by direction: radiance on a longitude-latitude map, as in .hdr files.
///
/// Up is +Y. Longitude grows along a row, seen from inside to the right; the middle column is +X,
/// a quarter turn further +Z. Row 0 is the bottom row, straight down; index `y * width + x`.
/// Radiance is constant within a texel. Since 0.1.
struct EnvironmentMap {
    int width = 0;                   ///< texels, 1 to 16384
    int height = 0;                  ///< texels, 1 to 16384
    std::vector<glm::vec3> radiance; ///< linear red, green, blue; any unit; finite, not negative
};

/// Converts a direction (any length but zero) to texture coordinates, 0 to 1, v upwards.
AOLIB_LIGHTING_EXPORT glm::vec2 latLong(const glm::vec3& direction);

/// Converts texture coordinates, 0 to 1, to a direction of unit length.
AOLIB_LIGHTING_EXPORT glm::vec3 latLongDirection(const glm::vec2& place);

/// Returns the radiance of the texel that contains a direction, in the map's unit.
/// Precondition: the map passes checkEnvironment().
AOLIB_LIGHTING_EXPORT glm::vec3 radianceFrom(const EnvironmentMap& map, const glm::vec3& direction);

/// Rotates a map about +Y by whole texels; light from +X moves towards +Z.
/// @param turn  angle as a share of a full turn, finite.
AOLIB_LIGHTING_EXPORT EnvironmentMap turned(const EnvironmentMap& map, float turn);

/// Checks the sizes of a map and that each radiance is finite and not negative.
/// Errors: InvalidOption, with the sizes or the texel. Since 0.1.
AOLIB_LIGHTING_EXPORT AoStatus checkEnvironment(const EnvironmentMap& map);

} // namespace aolib::lighting
