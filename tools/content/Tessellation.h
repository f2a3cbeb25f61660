#pragma once

#include <cstddef>

#include "content/Model.h"

namespace aolib {

/// The model with edges halved until none is longer than said, or there would be more triangles
/// than said: values of vertices need vertices where they change. Neighbours stay neighbours: an
/// edge is halved in all of its triangles or in none.
/// @param longest  world units, above 0.
Model tessellated(Model model, float longest, std::size_t mostTriangles);

} // namespace aolib
