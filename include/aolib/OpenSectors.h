#pragma once

#include <array>

namespace aolib {

/// How open each of 24 sectors of directions is, 0 to 1, by the measure of who tells it. Sectors
/// are the faces of a cube along world space's axes, each in quarters; number: 8 for each axis (x,
/// y, z), 1, 2 and 4 where x, y and z are positive. Bakers tell them of vertices
/// (`bake::RayOptions::sectors`), and `lighting::sectorLight()` lights by them. Since 0.1.
using OpenSectors = std::array<float, 24>;

} // namespace aolib
