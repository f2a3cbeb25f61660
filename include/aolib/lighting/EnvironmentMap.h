#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/Status.h>

namespace aolib::lighting {

/// Light from far away, by direction: a map by longitude and latitude, as .hdr files hold it.
///
/// Up is +Y. Along a row longitude grows: seen from inside, to the right; the middle column is +X,
/// a quarter further +Z. Row 0 is the bottom row, straight down; index `y * width + x`. A texel
/// has one radiance throughout. Since 0.1.
struct EnvironmentMap {
    int width = 0;                   ///< texels, 1 to 16384
    int height = 0;                  ///< texels, 1 to 16384
    std::vector<glm::vec3> radiance; ///< linear red, green, blue; any unit; finite, not negative
};

/// Where a direction (any length but zero) lies on a map, 0 to 1 each way, v upwards.
AOLIB_LIGHTING_EXPORT glm::vec2 latLong(const glm::vec3& direction);

/// The direction of a place on a map, unit length.
AOLIB_LIGHTING_EXPORT glm::vec3 latLongDirection(const glm::vec2& place);

/// The radiance of the texel that a direction falls on. The map must be good.
AOLIB_LIGHTING_EXPORT glm::vec3 radianceFrom(const EnvironmentMap& map, const glm::vec3& direction);

/// The map turned about +Y, by whole texels: what came from +X comes from nearer to +Z.
/// @param turn  share of a full turn, finite.
AOLIB_LIGHTING_EXPORT EnvironmentMap turned(const EnvironmentMap& map, float turn);

/// Whether a map is what EnvironmentMap promises.
/// Errors: InvalidOption, with the sizes or the texel. Since 0.1.
AOLIB_LIGHTING_EXPORT AoStatus checkEnvironment(const EnvironmentMap& map);

} // namespace aolib::lighting
