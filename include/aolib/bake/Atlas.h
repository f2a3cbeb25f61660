#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include <aolib/BakeExport.h>
#include <aolib/Status.h>
#include <aolib/bake/BakeScene.h>

namespace aolib::bake {

/// A surface cut into charts, its vertices split where charts meet.
struct UnwrappedSurface {
    std::vector<std::uint32_t> source;  ///< the old vertex behind each new one
    std::vector<glm::vec2> uvs;         ///< of the new vertices
    std::vector<std::uint32_t> indices; ///< into the new vertices; triangles in their old order
};

/// UVs of our own for surfaces that share a map. Since 0.1.
struct Atlas {
    std::vector<UnwrappedSurface> surfaces; ///< as many as were given, in their order
    std::size_t charts = 0;
    double usedShare = 0.0; ///< of the map's area that triangles cover
};

/// Cuts surfaces into charts of triangles that face alike, lays each onto its own plane and packs
/// them by rows, all at one scale. Neither angles nor areas are distorted by more than the cosine
/// of the cone that a chart's normals fill; a chart that still covers itself is cut into single
/// triangles.
/// @param width,height  of the map, texels.
/// @param gap           between charts, texels. Each chart keeps half of it to every side, and has
/// the squares of its edge (of the next power of two below it) for itself: so many texels of a
/// filled map average to one in a mipmap before charts mix.
/// Errors: InvalidOption (so many charts that none would get a texel), OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<Atlas> makeAtlas(const std::vector<const Surface*>& surfaces, int width,
                                          int height, int gap);

/// The surface with the vertices and UVs that makeAtlas() gave it.
AOLIB_BAKE_EXPORT Surface withAtlas(const Surface& surface, const UnwrappedSurface& unwrapped);

} // namespace aolib::bake
