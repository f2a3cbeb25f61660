#include "content/ModelFile.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <string>

#include "content/FileBytes.h"
#include "content/GltfReader.h"
#include "content/ObjReader.h"

namespace aolib {
namespace {

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

} // namespace

bool isModelFile(const std::filesystem::path& file) {
    const std::string extension = lowerExtension(file);
    return extension == ".glb" || extension == ".gltf" || extension == ".obj";
}

Result<Model, LoadError> readModel(std::string_view bytes, const std::filesystem::path& file) {
    const std::string name = file.string();
    if (!isModelFile(file)) {
        return LoadError{name + ": not a model file (.glb, .gltf and .obj are known)"};
    }
    if (bytes.empty()) {
        return LoadError{name + ": the file is empty"};
    }
    try {
        Result<Model, LoadError> model =
            lowerExtension(file) == ".obj" ? readObj(bytes, file) : readGltf(bytes, file);
        if (model && model->triangleCount() == 0) {
            return LoadError{name + ": holds no triangles"};
        }
        if (model) {
            model->name = file.stem().string();
        }
        return model;
    } catch (const std::exception& failure) {
        return LoadError{name + ": cannot be read (" + failure.what() + ")"};
    }
}

Result<Model, LoadError> loadModel(const std::filesystem::path& file) {
    const Result<std::string, LoadError> bytes = readFileBytes(file);
    if (!bytes) {
        return bytes.error();
    }
    return readModel(*bytes, file);
}

} // namespace aolib
