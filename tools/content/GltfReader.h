#pragma once

#include <filesystem>
#include <string_view>

#include "content/LoadError.h"
#include "content/Model.h"

namespace aolib {

/// Reads the default scene of a .gltf or .glb: triangles, strips and fans of every node, with
/// normals and base colours; points and lines are skipped, and so are images, skins and
/// animations. A node that is reached twice, a missing node, indices out of range and values that
/// are not finite are errors. Where a primitive lacks normals, `ModelMesh::normals` stays empty.
Result<Model, LoadError> readGltf(std::string_view bytes, const std::filesystem::path& file);

} // namespace aolib
