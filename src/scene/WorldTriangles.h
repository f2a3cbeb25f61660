#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "scene/Scene.h"
#include "scene/TriangleMesh.h"

namespace aolib {

/// Takes normals of a mesh to world space: the inverse transpose of the transform's linear part up
/// to a positive factor, its largest element 1; singular transforms have one, too. Zero where the
/// transform leaves less than a plane of the mesh.
glm::dmat3 normalMatrix(const glm::mat4& transform);

/// All triangles of a scene as one mesh, mesh by mesh. Has normals if any of the meshes has: of
/// length 1, or zero where a mesh or a vertex has none.
TriangleMesh worldTriangles(const Scene& scene);

} // namespace aolib
