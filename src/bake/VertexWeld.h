#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bake/BakeGeometry.h"

namespace aolib::bake {

/// Vertices of the surfaces whose values are wanted, those at one place that face alike being one:
/// where only UVs part them, values must not.
struct VertexWeld {
    /// Per surface and vertex its number, or `unused`.
    std::vector<std::vector<std::uint32_t>> number;
    /// Per number: a place on the largest triangle about the vertex, next to it (a vertex in a
    /// crease lies in other surfaces, too); the normal as given, or the triangles' mean.
    std::vector<SurfacePoint> points;
    static constexpr std::uint32_t unused = ~0U;
};

/// Of all surfaces that do not only occlude.
VertexWeld weldVertices(const BakeGeometry& geometry);

} // namespace aolib::bake
