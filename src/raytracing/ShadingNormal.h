#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raytracing/RayScene.h"
#include "scene/TriangleMesh.h"

namespace aolib {

/// The normal that visibility at a hit is about: the mesh's, interpolated, of length 1, on the side
/// of `geometric`; `geometric` where the mesh has none or where they cancel out.
/// @param geometric  of the hit, of length 1, turned to the viewer.
inline glm::dvec3 shadingNormal(const TriangleMesh& mesh, const Hit& hit,
                                const glm::dvec3& geometric) {
    if (mesh.normals.empty()) {
        return geometric;
    }
    const std::uint32_t* index = &mesh.indices[std::size_t{hit.triangle} * 3];
    const glm::dvec3 normal = (1.0 - hit.u - hit.v) * glm::dvec3(mesh.normals[index[0]]) +
                              hit.u * glm::dvec3(mesh.normals[index[1]]) +
                              hit.v * glm::dvec3(mesh.normals[index[2]]);
    const double length = glm::length(normal);
    if (!(length > 0.0)) {
        return geometric;
    }
    return glm::dot(normal, geometric) < 0.0 ? -normal / length : normal / length;
}

} // namespace aolib
