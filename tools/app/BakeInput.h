#pragma once

#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include <aolib/bake/BakeScene.h>

#include "app/Failure.h"
#include "content/GltfEdit.h"
#include "content/Model.h"
#include "scene/Bounds.h"

namespace aolib::app {

/// A primitive of a node: what is baked, and where it goes back.
struct BakePiece {
    std::string name;
    GltfOrigin origin;
    glm::mat4 transform{1.0F};
    bool mirrored = false; ///< by its transform: `surface` has each triangle turned round
    bake::Surface surface; ///< world space
    std::vector<std::vector<glm::vec2>> uvSets; ///< v upwards
};

/// A model to bake, as the glTF that it will be written back to.
struct BakeInput {
    std::string name;
    std::string gltf; ///< the file, or what a shape or scene was made to
    GltfEdit edit;
    std::vector<BakePiece> pieces;
    Bounds bounds;
};

/// A mesh in world space, as it is baked.
bake::Surface placedSurface(ModelMesh mesh);

/// Opens a model file, a shape with UVs ("uv-sphere"), or a generated scene. Errors: BadInput.
Result<BakeInput, Failure> openBakeInput(const std::string& nameOrPath);

} // namespace aolib::app
