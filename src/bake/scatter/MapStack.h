#pragma once

#include <glm/vec2.hpp>

namespace aolib::bake {

/// The maps that one target holds, one above the other.
struct MapStack {
    glm::ivec2 mapSize{0}; ///< texels
    int first = 0;         ///< number of the lowest
    int count = 0;
};

} // namespace aolib::bake
