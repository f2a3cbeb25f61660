#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include <aolib/bake/BakeScene.h>

namespace aolib::bake {

/// Triangles of one surface laid onto a plane.
struct AtlasChart {
    std::size_t surface = 0;
    std::vector<std::uint32_t> triangles;
    std::vector<glm::vec2> corners; ///< three per triangle, world units, from (0, 0) up
    glm::vec2 size{0.0F};           ///< of the rectangle about them, world units
    float area = 0.0F;              ///< of the triangles in the plane, square world units
};

/// Cuts a surface into charts: from each triangle left, all are taken that hang together with it
/// and face within 45 degrees of it. A chart that then covers itself is cut into its triangles.
/// Triangles without area are in no chart.
std::vector<AtlasChart> cutCharts(const Surface& surface, std::size_t number);

} // namespace aolib::bake
