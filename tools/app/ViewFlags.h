#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <glm/vec3.hpp>

#include <aolib/Options.h>

#include "app/Outcome.h"
#include "content/Case.h"
#include "content/Model.h"
#include "content/NamedCamera.h"
#include "host/ModelScene.h"

namespace aolib::app {

/// A scene, opened, and how to look at it.
struct View {
    Model model;
    NamedCamera camera;
    int width = 960;  ///< pixels
    int height = 540; ///< pixels
    host::SceneNormals normals = host::SceneNormals::Geometric;
    Options options;       ///< defaults, but for what a case file says
    double diagonal = 0.0; ///< of the bounding box without ground, world units
};

/// The flags that say what is looked at, and from where: scene or case file, camera, size, normals.
class ViewFlags {
public:
    /// Adds the flags to a command. The object must outlive it.
    void attach(CLI::App& command);

    /// Reads the scene. Flags override what a case file says. Errors: BadInput.
    Outcome<View> open() const;

private:
    Outcome<View> openCase() const;
    Outcome<View> openScene() const;
    Outcome<NamedCamera> namedCamera(const Model& model) const;
    MaybeFailure applyFlags(View& view) const;
    void overrideCamera(NamedCamera& camera, const Model& model) const;

    std::string scene_;
    std::string case_;
    std::string camera_;
    std::optional<glm::vec3> eye_;
    std::optional<glm::vec3> target_;
    std::optional<glm::vec3> up_;
    std::optional<double> fovyDeg_;
    std::optional<double> near_;
    std::optional<double> far_;
    std::optional<double> ground_;
    std::optional<int> width_;
    std::optional<int> height_;
    std::optional<host::SceneNormals> normals_;
};

} // namespace aolib::app
