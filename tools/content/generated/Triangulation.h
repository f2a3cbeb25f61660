#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib {

/// A closed polygon; consecutive points differ and the last joins the first.
using Outline = std::vector<glm::vec2>;

/// Triangulates a simple polygon with disjoint holes, using exactly the given points.
/// @param outline  counter-clockwise
/// @param holes    any winding, inside the outline, touching neither it nor each other
/// @return counter-clockwise triangles of indices into outline + holes[0] + holes[1] ...
std::vector<std::array<std::size_t, 3>> triangulate(const Outline& outline,
                                                    const std::vector<Outline>& holes = {});

} // namespace aolib
