#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace aolib::bake {

/// Positions and normals of a view's pixels, as a renderer's buffers hold them, row by row from the
/// bottom. Since 0.1.
struct ViewPixels {
    int width = 0;                    ///< pixels, 1 to 16384
    int height = 0;                   ///< pixels, 1 to 16384
    std::vector<glm::vec3> positions; ///< world units
    std::vector<glm::vec3> normals;   ///< shading normals on the visible side, any length; 0 if the
                                      ///< pixel shows nothing
    std::vector<glm::vec3> planes;    ///< geometric normals; empty if they are `normals`
    float lift = 0.0F; ///< greatest distance of positions below their surface, world units, 0 or
                       ///< more: positions from depths are rounded
};

} // namespace aolib::bake
