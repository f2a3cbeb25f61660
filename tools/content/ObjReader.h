#pragma once

#include <filesystem>
#include <string_view>

#include "content/LoadError.h"
#include "content/Model.h"

namespace aolib {

/// Reads Wavefront OBJ text as one mesh: `v`, `vn` and `f` with every form of index, negative ones
/// included; polygons become fans. Normals are kept when every corner has one. Texture coordinates,
/// groups, materials, points and lines are skipped. Errors name the line.
Result<Model, LoadError> readObj(std::string_view text, const std::filesystem::path& file);

} // namespace aolib
