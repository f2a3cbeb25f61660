#include "content/SceneSource.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "content/DefaultCameras.h"
#include "content/ModelFile.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib {
namespace {

constexpr const char* installedBunny = "/usr/share/glmark2/models/bunny.obj";

} // namespace

Result<Model, LoadError> openScene(const std::string& nameOrPath) {
    if (const GeneratedScene* scene = findGeneratedScene(nameOrPath)) {
        return scene->build();
    }
    std::error_code code;
    if (std::filesystem::path(nameOrPath).has_extension() ||
        std::filesystem::exists(nameOrPath, code)) {
        return loadModel(nameOrPath);
    }
    std::string names;
    for (const GeneratedScene& scene : generatedScenes()) {
        names += std::string(names.empty() ? "" : ", ") + scene.name;
    }
    return LoadError{nameOrPath + ": neither a file nor a generated scene (" + names + ")"};
}

std::vector<NamedCamera> camerasFor(const std::string& nameOrPath, const Model& model) {
    const GeneratedScene* scene = findGeneratedScene(nameOrPath);
    return scene != nullptr ? scene->cameras() : defaultCameras(model);
}

std::vector<std::filesystem::path> findModels(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code code;
    std::filesystem::directory_iterator entry(folder, code);
    while (!code && entry != std::filesystem::directory_iterator()) {
        if (isModelFile(entry->path()) && entry->is_regular_file(code)) {
            files.push_back(entry->path());
        }
        entry.increment(code);
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::optional<std::filesystem::path> defaultModelsDir() {
    const char* chosen = std::getenv("AOLIB_MODELS_DIR");
    if (chosen != nullptr && *chosen != '\0') {
        return std::filesystem::path(chosen);
    }
    const std::filesystem::path beside =
        std::filesystem::path(AOLIB_SOURCE_DIR).parent_path() / "shared" / "models";
    std::error_code code;
    return std::filesystem::is_directory(beside, code) ? std::optional(beside) : std::nullopt;
}

std::vector<std::filesystem::path> availableModels() {
    std::vector<std::filesystem::path> files;
    if (const std::optional<std::filesystem::path> folder = defaultModelsDir()) {
        files = findModels(*folder);
    }
    const bool haveBunny =
        std::any_of(files.begin(), files.end(), [](const auto& f) { return f.stem() == "bunny"; });
    std::error_code code;
    if (!haveBunny && std::filesystem::is_regular_file(installedBunny, code)) {
        files.emplace_back(installedBunny);
    }
    return files;
}

} // namespace aolib
