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
    std::vector<std::uint32_t> source;  ///< per new vertex: index of the old one
    std::vector<glm::vec2> uvs;         ///< of the new vertices
    std::vector<std::uint32_t> indices; ///< into the new vertices; triangles in their old order
};

/// Generated UVs for surfaces that share a map. Since 0.1.
struct Atlas {
    std::vector<UnwrappedSurface> surfaces; ///< as many as were given, in their order
    std::size_t charts = 0;
    double usedShare = 0.0; ///< share of the map's area that triangles cover
};

/// Cuts surfaces into charts of triangles that face alike, projects each chart onto a plane, and
/// packs the charts by rows, all at one scale. Neither angles nor areas are distorted by more than
/// the cosine of the cone that a chart's normals fill. A chart that overlaps itself is cut into
/// single triangles.
/// @param width,height  of the map, texels.
/// @param gap           between charts, texels. Each chart keeps half of the gap to every side. Its
/// place is made of whole squares, whose edge is the largest power of two up to the gap. So that
/// many texels of a filled map can be averaged to one in a mipmap before charts mix. Errors:
/// InvalidOption (so many charts that none would get a texel), OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<Atlas> makeAtlas(const std::vector<const Surface*>& surfaces, int width,
                                          int height, int gap);

/// Returns the surface with the vertices and UVs that makeAtlas() made for it.
AOLIB_BAKE_EXPORT Surface withAtlas(const Surface& surface, const UnwrappedSurface& unwrapped);

} // namespace aolib::bake
