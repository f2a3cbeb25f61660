#pragma once

#include <filesystem>
#include <string_view>

#include "content/LoadError.h"
#include "content/Model.h"

namespace aolib {

/// Reads a .glb, .gltf or .obj file. Every failure is one sentence that names the file and the
/// reason: unreadable, truncated, of unknown kind, not finite, indices out of range, no triangles.
Result<Model, LoadError> loadModel(const std::filesystem::path& file);

/// The same from memory; `file` gives the kind (by its extension), the name in messages and the
/// folder of the files it refers to.
Result<Model, LoadError> readModel(std::string_view bytes, const std::filesystem::path& file);

/// Whether a file's extension names a kind that loadModel() knows.
bool isModelFile(const std::filesystem::path& file);

} // namespace aolib
