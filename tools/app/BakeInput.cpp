#include "app/BakeInput.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <utility>

#include <glm/matrix.hpp>

#include "content/FileBytes.h"
#include "content/GltfAccessor.h"
#include "content/GltfBuild.h"
#include "content/GltfReader.h"
#include "content/ModelFile.h"
#include "content/SceneSource.h"
#include "content/generated/AnimatedModels.h"

namespace aolib::app {

namespace {

bool isGltf(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    return extension == ".glb" || extension == ".gltf" || extension == ".GLB" ||
           extension == ".GLTF";
}

/// The bytes of a glTF: the file's, or one made of a shape, a scene or another kind of file.
Result<std::string, LoadError> gltfBytes(const std::string& nameOrPath) {
    if (isGltf(nameOrPath)) {
        return readFileBytes(nameOrPath);
    }
    const auto packed = [](const GltfParts& parts) -> Result<std::string, LoadError> {
        const Result<GltfEdit, LoadError> edit = GltfEdit::open(parts, {});
        return edit ? edit->glb() : Result<std::string, LoadError>(edit.error());
    };
    if (const UvMesh shape = uvShape(nameOrPath); !shape.indices.empty()) {
        return packed(gltfOf(shape, nameOrPath));
    }
    const std::vector<std::string> moving = animatedModelNames();
    if (std::find(moving.begin(), moving.end(), nameOrPath) != moving.end()) {
        return animatedModel(nameOrPath);
    }
    const Result<Model, LoadError> model = openScene(nameOrPath);
    if (!model) {
        std::string shapes;
        for (const std::string& name : uvShapeNames()) {
            shapes += (shapes.empty() ? "" : ", ") + name;
        }
        return LoadError{model.error().sentence + "; shapes with UVs are " + shapes};
    }
    return packed(gltfOf(*model));
}

Result<std::vector<std::vector<glm::vec2>>, LoadError>
uvSetsOf(const GltfDocument& document, const GltfOrigin& origin, std::size_t vertices) {
    const auto& primitive = document.structure.meshes[static_cast<std::size_t>(origin.mesh)]
                                .primitives[static_cast<std::size_t>(origin.primitive)];
    std::vector<std::vector<glm::vec2>> sets;
    for (int set = 0;; ++set) {
        const auto found = primitive.attributes.find("TEXCOORD_" + std::to_string(set));
        if (found == primitive.attributes.end()) {
            return sets;
        }
        Result<std::vector<glm::vec2>, LoadError> uvs = readPairs(document, found->second);
        if (!uvs) {
            return uvs.error();
        }
        if (uvs->size() != vertices) {
            return LoadError{document.name + ": mesh " + std::to_string(origin.mesh) + " has " +
                             std::to_string(uvs->size()) + " UVs for " + std::to_string(vertices) +
                             " positions"};
        }
        for (glm::vec2& uv : *uvs) {
            uv.y = 1.0F - uv.y; // glTF counts from the top
        }
        sets.push_back(std::move(*uvs));
    }
}

BakePiece pieceOf(ModelMesh mesh) {
    BakePiece piece;
    piece.name = mesh.name;
    piece.origin = mesh.origin;
    piece.transform = mesh.transform;
    piece.mirrored = glm::determinant(glm::mat3(mesh.transform)) < 0.0F;
    piece.surface = placedSurface(std::move(mesh));
    return piece;
}

Result<BakeInput, LoadError> readInput(const std::string& nameOrPath) {
    const Result<std::string, LoadError> bytes = gltfBytes(nameOrPath);
    if (!bytes) {
        return bytes.error();
    }
    const std::filesystem::path file(nameOrPath);
    const Result<GltfDocument, LoadError> document = parseGltf(*bytes, file);
    if (!document) {
        return document.error();
    }
    Result<Model, LoadError> model = readGltf(*bytes, file);
    if (!model) {
        return model.error();
    }
    if (model->triangleCount() == 0) {
        return LoadError{nameOrPath + ": holds no triangles"};
    }
    const Result<GltfParts, LoadError> parts = openGltf(*bytes, file);
    if (!parts) {
        return parts.error();
    }
    Result<GltfEdit, LoadError> edit = GltfEdit::open(*parts, file.parent_path());
    if (!edit) {
        return edit.error();
    }
    BakeInput input{file.stem().string(), *bytes, std::move(*edit), {}, model->bounds()};
    for (ModelMesh& mesh : model->meshes) {
        auto sets = uvSetsOf(*document, mesh.origin, mesh.positions.size());
        if (!sets) {
            return sets.error();
        }
        input.pieces.push_back(pieceOf(std::move(mesh)));
        input.pieces.back().uvSets = std::move(*sets);
    }
    return input;
}

} // namespace

bake::Surface placedSurface(ModelMesh mesh) {
    Model alone;
    alone.meshes.push_back(std::move(mesh));
    TriangleMesh placed = alone.flattened();
    bake::Surface surface;
    surface.positions = std::move(placed.positions);
    surface.normals = std::move(placed.normals);
    surface.indices = std::move(placed.indices);
    return surface;
}

Result<BakeInput, Failure> openBakeInput(const std::string& nameOrPath) {
    try {
        Result<BakeInput, LoadError> input = readInput(nameOrPath);
        if (!input) {
            return badInput(input.error().sentence);
        }
        return std::move(*input);
    } catch (const std::exception& error) {
        return badInput(nameOrPath + ": cannot be read (" + error.what() + ")");
    }
}

} // namespace aolib::app
