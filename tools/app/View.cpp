#include "app/View.h"

#include <utility>
#include <vector>

#include "content/Case.h"
#include "content/SceneSource.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib::app {

namespace {

Result<NamedCamera, Failure> namedCamera(const std::string& scene, const std::string& name,
                                         const Model& model) {
    std::string names;
    for (const NamedCamera& camera : camerasFor(scene, model)) {
        if (name.empty() || camera.name == name) {
            return camera;
        }
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    return badInput("--camera " + name + ": " + scene + " has no such camera, but " + names);
}

} // namespace

void addGround(View& view, float y) {
    view.ground = y;
    aolib::addGround(view.model, y);
}

Result<View, Failure> openCaseView(const std::string& file, std::optional<float> ground) {
    Result<Case, LoadError> description = readCase(file);
    if (!description) {
        return badInput(description.error().sentence);
    }
    const std::optional<float> own = std::exchange(description->ground, std::nullopt);
    Result<Model, LoadError> model = loadCaseModel(*description);
    if (!model) {
        return badInput(model.error().sentence);
    }
    View view;
    const bool generated = findGeneratedScene(description->mesh) != nullptr;
    view.scene = generated ? description->mesh : (description->folder / description->mesh).string();
    view.model = std::move(*model);
    view.diagonal = static_cast<double>(view.model.bounds().diagonal());
    view.camera = caseCamera(*description);
    view.width = description->width;
    view.height = description->height;
    view.normals = description->normals == CaseNormals::Given ? host::SceneNormals::Model
                                                              : host::SceneNormals::Geometric;
    view.options.radius = description->radius;
    view.options.falloff = description->falloff;
    if (ground || own) {
        addGround(view, ground ? *ground : *own);
    }
    return view;
}

Result<View, Failure> openSceneView(const std::string& nameOrPath, const std::string& camera) {
    Result<Model, LoadError> model = openScene(nameOrPath);
    if (!model) {
        return badInput(model.error().sentence);
    }
    View view;
    view.scene = nameOrPath;
    view.model = std::move(*model);
    view.diagonal = static_cast<double>(view.model.bounds().diagonal());
    const Result<NamedCamera, Failure> found = namedCamera(nameOrPath, camera, view.model);
    if (!found) {
        return found.error();
    }
    view.camera = *found;
    return view;
}

} // namespace aolib::app
