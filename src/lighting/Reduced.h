#pragma once

#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// A map of half the width and height (rounded down; at least 1), as mipmaps are: each texel the
/// mean of those that it covers, by their steradians.
EnvironmentMap halved(const EnvironmentMap& map);

/// The map itself, or halved until it has at most so many rows.
EnvironmentMap reduced(EnvironmentMap map, int rows);

} // namespace aolib::lighting
