#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "content/LoadError.h"
#include "content/Model.h"
#include "content/NamedCamera.h"

namespace aolib {

/// The generated scene of this name, or else the model in this file.
Result<Model, LoadError> openScene(const std::string& nameOrPath);

/// The views of a scene that openScene() gave: the generated scene's own, or defaultCameras().
std::vector<NamedCamera> camerasFor(const std::string& nameOrPath, const Model& model);

/// The model files directly in a folder, sorted by name; empty when there is no such folder.
std::vector<std::filesystem::path> findModels(const std::filesystem::path& folder);

/// Where real models are: the environment variable AOLIB_MODELS_DIR, or else `../shared/models`
/// beside the source tree when that exists.
std::optional<std::filesystem::path> defaultModelsDir();

/// The models in defaultModelsDir() and, where none of them is a bunny, the one that the package
/// glmark2-data installs.
std::vector<std::filesystem::path> availableModels();

} // namespace aolib
