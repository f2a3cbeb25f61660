#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/Mesh.h"

namespace aolib {

/// The closed parts of a mesh. Vertices at equal positions are welded; a connected component is a
/// solid if each of its edges is used as often in one direction as in the other. Only in a solid
/// does a front face along a ray pair with the next back face. All other components are open
/// meshes.
struct Solids {
    /// Added to the number that a mesh's open components share, to distinguish it from solids.
    /// Numbers up to twice as large are exact in a float, which is how shaders read them.
    static constexpr std::uint32_t kOpenMesh = 1U << 22U;

    /// Per vertex: 1 + the index of its solid, or kOpenMesh + count() for the open components,
    /// which share one number.
    std::vector<std::uint32_t> solidOfVertex;
    /// Triangles, turned so that the normals of every solid point outwards: the triangles of
    /// inside-out solids are reversed.
    std::vector<std::uint32_t> indices;
    /// Model-space bounds per solid.
    std::vector<Bounds> bounds;
    /// Whether some component is an open mesh.
    bool openMesh = false;

    /// Returns how many numbers the mesh uses: one per solid, and one for its open components if
    /// any.
    std::uint32_t count() const {
        return static_cast<std::uint32_t>(bounds.size()) + (openMesh ? 1U : 0U);
    }
};

Solids findSolids(const Mesh& mesh);

/// Returns the indices of the solids that contain a point (model space), found by the parity of
/// crossings along a ray.
std::vector<std::uint32_t> enclosingSolids(const Mesh& mesh, const Solids& solids,
                                           const glm::vec3& point);

} // namespace aolib
