#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace aolib::bake {

/// The places that a view shows, as a renderer's buffers hold them: one per pixel, row by row from
/// the bottom. Since 0.1.
struct ViewPixels {
    int width = 0;                    ///< pixels, 1 to 16384
    int height = 0;                   ///< pixels, 1 to 16384
    std::vector<glm::vec3> positions; ///< world units
    std::vector<glm::vec3> normals;   ///< shading normals on the side that is seen, any length; 0:
                                      ///< the pixel shows nothing
    std::vector<glm::vec3> planes;    ///< the surfaces' own normals; empty: `normals` are
    float lift = 0.0F; ///< how far below their surface positions may lie by rounding, as those do
                       ///< that were made of depths, world units, 0 or more
};

} // namespace aolib::bake
