#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include "app/Failure.h"
#include "app/View.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// What a command takes where no flag and no case file says otherwise.
struct ViewDefaults {
    std::string scene; ///< empty: naming none is an error
    int width = 960;   ///< pixels
    int height = 540;  ///< pixels
};

/// The flags that say what is looked at, and from where: scene or case file, camera, size, normals.
class ViewFlags {
public:
    /// Adds the flags to a command. The object must outlive it.
    void attach(CLI::App& command, const ViewDefaults& defaults = {});

    /// Reads the scene. Flags override what a case file says. Errors: BadInput.
    Result<View, Failure> open() const;
    /// Whether a scene or a case file was named.
    bool named() const { return !scene_.empty() || !case_.empty(); }

private:
    MaybeFailure applyFlags(View& view) const;
    void overrideCamera(NamedCamera& camera, const Model& model) const;

    ViewDefaults defaults_;
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
