#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

#include <aolib/bake/AbstractBaker.h>

#include "bake/geometry/BakeGeometry.h"

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

/// The surfaces' vertices with the values of their numbers.
/// @param values  per number: W, clamped to [0,1] here, and a direction of any length; where that
/// is zero the normal takes its place.
/// @param sectors  per number, or none.
std::vector<BakedVertices> unweldedVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                            const std::vector<glm::vec4>& values,
                                            const std::vector<OpenSectors>& sectors = {});

} // namespace aolib::bake
