#include "app/ViewFlags.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/NumberFlags.h"
#include "content/SceneSource.h"

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

void ViewFlags::attach(CLI::App& command) {
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
    const auto side = [&](const char* flag, std::optional<int>& into, const char* help) {
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
    side("--width", width_, "width of the picture [960]");
    side("--height", height_, "height of the picture [540]");
    number("--ground", ground_, "adds a large horizontal quad at this y");
    addChoice<host::SceneNormals>(
        command, "--normals",
        {{"geometric", host::SceneNormals::Geometric}, {"given", host::SceneNormals::Model}},
        [this](host::SceneNormals value) { normals_ = value; },
        "normals that occlusion is about: the triangles' or the model's")
        ->default_str("geometric")
        ->group("View");
}

Outcome<View> ViewFlags::open() const {
    if (scene_.empty() == case_.empty()) {
        return badInput(case_.empty() ? "a scene or --case is needed; \"aolib scenes\" lists some"
                                      : "--case " + case_ + ": it names its scene itself, so \"" +
                                            scene_ + "\" is one too many");
    }
    if (!case_.empty() && !camera_.empty()) {
        return badInput("--camera " + camera_ + ": a case file has its own camera");
    }
    Outcome<View> view = case_.empty() ? openScene() : openCase();
    if (!view) {
        return view;
    }
    if (MaybeFailure failure = applyFlags(*view)) {
        return *failure;
    }
    return view;
}

Outcome<View> ViewFlags::openCase() const {
    Loaded<Case> description = readCase(case_);
    if (!description) {
        return badInput(description.sentence());
    }
    const std::optional<float> ground = std::exchange(description->ground, std::nullopt);
    Loaded<Model> model = loadCaseModel(*description);
    if (!model) {
        return badInput(model.sentence());
    }
    View view;
    view.model = std::move(*model);
    view.diagonal = static_cast<double>(view.model.bounds().diagonal());
    view.camera = caseCamera(*description);
    view.width = description->width;
    view.height = description->height;
    view.normals = description->normals == CaseNormals::Given ? host::SceneNormals::Model
                                                              : host::SceneNormals::Geometric;
    view.options.radius = description->radius;
    view.options.falloff = description->falloff;
    if (ground && !ground_) {
        addGround(view.model, *ground);
    }
    return view;
}

Outcome<View> ViewFlags::openScene() const {
    Loaded<Model> model = aolib::openScene(scene_);
    if (!model) {
        return badInput(model.sentence());
    }
    View view;
    view.model = std::move(*model);
    view.diagonal = static_cast<double>(view.model.bounds().diagonal());
    const Outcome<NamedCamera> camera = namedCamera(view.model);
    if (!camera) {
        return camera.failure();
    }
    view.camera = *camera;
    return view;
}

Outcome<NamedCamera> ViewFlags::namedCamera(const Model& model) const {
    const std::vector<NamedCamera> cameras = camerasFor(scene_, model);
    std::string names;
    for (const NamedCamera& camera : cameras) {
        if (camera_.empty() || camera.name == camera_) {
            return camera;
        }
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    return badInput("--camera " + camera_ + ": " + scene_ + " has no such camera, but " + names);
}

MaybeFailure ViewFlags::applyFlags(View& view) const {
    view.width = width_.value_or(view.width);
    view.height = height_.value_or(view.height);
    view.normals = normals_.value_or(view.normals);
    overrideCamera(view.camera, view.model);
    if (ground_) {
        addGround(view.model, static_cast<float>(*ground_));
    }
    return check(view.camera);
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
