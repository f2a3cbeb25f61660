#pragma once

#include <optional>
#include <string>

#include <aolib/Options.h>

#include "app/Failure.h"
#include "content/Model.h"
#include "content/NamedCamera.h"
#include "host/ModelScene.h"

namespace aolib::app {

/// A scene, opened, and how to look at it.
struct View {
    std::string scene; ///< the generated scene's name, or the model's file
    Model model;
    NamedCamera camera;
    int width = 960;  ///< pixels
    int height = 540; ///< pixels
    host::SceneNormals normals = host::SceneNormals::Geometric;
    std::optional<float> ground; ///< y of the quad that was added to the model
    Options options;             ///< defaults, but for what a case file says
    double diagonal = 0.0;       ///< of the bounding box without ground, world units
};

/// Adds a ground to a view, and notes it.
void addGround(View& view, float y);

/// A case file's view. Errors: BadInput.
/// @param ground  in place of the case's own.
Result<View, Failure> openCaseView(const std::string& file, std::optional<float> ground = {});

/// A generated scene or a model file, from one of its cameras, the first if none is named.
/// Errors: BadInput.
Result<View, Failure> openSceneView(const std::string& nameOrPath, const std::string& camera = {});

} // namespace aolib::app
