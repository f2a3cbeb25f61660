#pragma once

#include "content/GltfDocument.h"
#include "content/Model.h"
#include "content/generated/UvShapes.h"

namespace aolib {

/// A model without a glTF of its own (from an OBJ file or a generator) as one: a node, a mesh and a
/// material for each of its meshes, of one colour.
GltfParts gltfOf(const Model& model);

/// A shape with UVs as a glTF of one mesh.
GltfParts gltfOf(const UvMesh& mesh, const std::string& name);

} // namespace aolib
