#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace aolib {

/// Makes positions that lie within `distance` (world units) of an earlier one bitwise equal to it,
/// so that solids built from several faces are closed exactly.
void weldPositions(std::vector<glm::vec3>& positions, float distance);

} // namespace aolib
