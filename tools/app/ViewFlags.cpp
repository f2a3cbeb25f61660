#include "app/ViewFlags.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/NumberFlags.h"

namespace aolib::app {

namespace {

constexpr int kMaxSide = 16384;
/// Where an eye is given but no planes: the near one, as a share of the scene's diagonal, and how
/// far beyond the farthest corner of the scene the far one lies.
constexpr double kNearShare = 0.001;
constexpr double kFarMargin = 1.05;
/// Sine of the angle between up and the view below which the picture would turn at will.
constexpr double kParallel = 1e-6;

MaybeFailure check(const NamedCamera& camera) {
    const glm::dvec3 forward = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 up(camera.up);
    if (glm::length(forward) == 0.0) {
        return badInput("--target: it must not be where --eye is");
    }
    if (!(glm::length(glm::cross(forward, up)) >
          kParallel * glm::length(forward) * glm::length(up))) {
        return badInput("--up: it must not be zero or point along the view");
    }
    if (!(camera.fovyDeg > 0.0F && camera.fovyDeg < 180.0F)) {
        return badInput("--fovy: an angle between 0 and 180 degrees is needed");
    }
    if (!(camera.near > 0.0F && camera.near < camera.far)) {
        return badInput("--near and --far: 0 < near < far is needed");
    }
    return std::nullopt;
}

double farthestCorner(const Bounds& bounds, const glm::vec3& eye) {
    const glm::dvec3 reach = glm::max(glm::abs(glm::dvec3(bounds.min) - glm::dvec3(eye)),
                                      glm::abs(glm::dvec3(bounds.max) - glm::dvec3(eye)));
    return glm::length(reach);
}

} // namespace

void ViewFlags::attach(CLI::App& command, const ViewDefaults& defaults) {
    defaults_ = defaults;
    command.add_option("scene", scene_,
                       "a generated scene (see \"aolib scenes\") or a .glb, .gltf or .obj file");
    command.add_option("--case", case_, "a case file (JSON) with scene, camera, size and radius")
        ->type_name("FILE")
        ->group("View");
    command.add_option("--camera", camera_, "one of the scene's cameras, see \"aolib scenes\"")
        ->type_name("NAME")
        ->group("View");
    const auto vector = [&](const char* flag, std::optional<glm::vec3>& into, const char* help) {
        addVector(
            command, flag, [&into](const glm::vec3& value) { into = value; }, help)
            ->group("View");
    };
    const auto number = [&](const char* flag, std::optional<double>& into, const char* help) {
        addNumber(
            command, flag, [&into](double value) { into = value; }, help)
            ->group("View");
    };
    const auto side = [&](const char* flag, std::optional<int>& into, const std::string& help) {
        addWholeNumber(
            command, flag, 1, kMaxSide, [&into](int value) { into = value; }, help)
            ->type_name("PIXELS")
            ->group("View");
    };
    vector("--eye", eye_, "where the camera is, world units");
    vector("--target", target_, "what it looks at");
    vector("--up", up_, "what is up in the picture");
    number("--fovy", fovyDeg_, "vertical field of view, degrees");
    number("--near", near_, "near plane; with --eye derived from the scene");
    number("--far", far_, "far plane; with --eye derived from the scene");
    const auto picture = [](const char* what, int size) {
        return std::string(what) + " of the picture [" + std::to_string(size) + "]";
    };
    side("--width", width_, picture("width", defaults.width));
    side("--height", height_, picture("height", defaults.height));
    number("--ground", ground_, "adds a large horizontal quad at this y");
    addChoice<host::SceneNormals>(
        command, "--normals",
        {{"geometric", host::SceneNormals::Geometric}, {"given", host::SceneNormals::Model}},
        [this](host::SceneNormals value) { normals_ = value; },
        "normals that occlusion is about: the triangles' or the model's")
        ->default_str("geometric")
        ->group("View");
}

Result<View, Failure> ViewFlags::open() const {
    const std::string& scene = named() ? scene_ : defaults_.scene;
    if (scene.empty() == case_.empty()) {
        return badInput(case_.empty() ? "a scene or --case is needed; \"aolib scenes\" lists some"
                                      : "--case " + case_ + ": it names its scene itself, so \"" +
                                            scene_ + "\" is one too many");
    }
    if (!case_.empty() && !camera_.empty()) {
        return badInput("--camera " + camera_ + ": a case file has its own camera");
    }
    const std::optional<float> ground =
        ground_ ? std::optional(static_cast<float>(*ground_)) : std::nullopt;
    Result<View, Failure> view =
        case_.empty() ? openSceneView(scene, camera_) : openCaseView(case_, ground);
    if (!view) {
        return view;
    }
    const bool sized = !case_.empty(); // by the case file
    view->width = width_.value_or(sized ? view->width : defaults_.width);
    view->height = height_.value_or(sized ? view->height : defaults_.height);
    view->normals = normals_.value_or(view->normals);
    overrideCamera(view->camera, view->model);
    if (ground && case_.empty()) {
        addGround(*view, *ground);
    }
    if (MaybeFailure failure = check(view->camera)) {
        return *failure;
    }
    return view;
}

void ViewFlags::overrideCamera(NamedCamera& camera, const Model& model) const {
    camera.eye = eye_.value_or(camera.eye);
    camera.target = target_.value_or(camera.target);
    camera.up = up_.value_or(camera.up);
    camera.fovyDeg = fovyDeg_ ? static_cast<float>(*fovyDeg_) : camera.fovyDeg;
    if (eye_) {
        const Bounds bounds = model.bounds();
        const double nearest = kNearShare * static_cast<double>(bounds.diagonal());
        camera.near = static_cast<float>(nearest);
        camera.far = static_cast<float>(
            std::max(kFarMargin * farthestCorner(bounds, camera.eye), 2.0 * nearest));
    }
    camera.near = near_ ? static_cast<float>(*near_) : camera.near;
    camera.far = far_ ? static_cast<float>(*far_) : camera.far;
}

} // namespace aolib::app
