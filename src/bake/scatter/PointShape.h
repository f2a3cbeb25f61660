#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"
#include "bake/maps/Facets.h"

namespace aolib::bake {

/// What all points that a triangle is scattered as have in common.
struct PointShape {
    glm::vec2 sides{0.0F}; ///< of the box that a point is, texels; 0: the nearest texel gets all
    float facet = 0.0F;    ///< 0: the triangle has no texels
    int map = -1;
};

/// How points are made.
struct PointSettings {
    glm::ivec2 mapSize{0};  ///< texels
    float pixelSize = 0.0F; ///< side of a pixel across the light, frame units
    float pointSize = 0.0F; ///< least side, texels; 0: the nearest texel gets all
};

/// Of all triangles, by their numbers. shaders/bake/footprint.glsl says the same on the GPU.
std::vector<PointShape> pointShapes(const BakeGeometry& geometry, const BakeFrame& frame,
                                    const Facets& facets, const PointSettings& settings);

} // namespace aolib::bake
