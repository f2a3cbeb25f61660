#pragma once

#include <array>

namespace aolib {

/// Unoccluded fraction of each of 24 direction sectors, 0 to 1; the producer states the weights.
/// A sector is a quarter of a face of a cube along the world axes.
/// Index = 8 axis + (x>0) + 2 (y>0) + 4 (z>0), with axis 0, 1, 2 for x, y, z.
/// Bakers compute them for vertices (`bake::RayOptions::sectors`); `lighting::sectorLight()`
/// computes radiance from them. Since 0.1.
using OpenSectors = std::array<float, 24>;

} // namespace aolib
