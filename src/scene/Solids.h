#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/Mesh.h"

namespace aolib {

/// Which parts of a mesh enclose space. Vertices at equal positions are welded; a connected
/// component is solid when each of its edges is run through as often one way as the other. Only in
/// a solid does a front face along a ray belong to the next back face; everything else is a sheet.
struct Solids {
    /// Added to the number of the mesh's sheets, to tell them from solids. Numbers up to twice as
    /// large are exact in a float, as which shaders get them.
    static constexpr std::uint32_t kOpenMeshes = 1U << 22U;

    /// Per vertex: 1 + the number of its solid, or kOpenMeshes + count() for the mesh's sheets, which
    /// share one number.
    std::vector<std::uint32_t> solidOfVertex;
    /// Triangles turned so that every solid's normals point outwards: those of an inside-out one
    /// are reversed.
    std::vector<std::uint32_t> indices;
    /// Model-space bounds per solid.
    std::vector<Bounds> bounds;
    /// Whether some of the mesh is no solid.
    bool sheets = false;

    /// How many numbers the mesh takes: one per solid and one for its sheets, if any.
    std::uint32_t count() const {
        return static_cast<std::uint32_t>(bounds.size()) + (sheets ? 1U : 0U);
    }
};

Solids findSolids(const Mesh& mesh);

/// The solids that contain a point (model space), by the parity of crossings along a ray.
std::vector<std::uint32_t> solidsAround(const Mesh& mesh, const Solids& solids,
                                        const glm::vec3& point);

} // namespace aolib
