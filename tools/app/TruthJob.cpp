#include "app/TruthJob.h"

#include <utility>

#include "raytracing/RayScene.h"
#include "reference/PictureTracer.h"

namespace aolib::app {

Result<Truth, Failure> traceTruth(const View& view, const Options& options, int rays,
                                  Progress& progress) {
    progress.begin(view.model.name + ": tracing the truth");
    Result<RayScene> scene = RayScene::create(view.model.flattened());
    if (!scene) {
        return badInput(view.model.name + ": " + scene.status().message());
    }
    PictureCamera camera;
    camera.view = glm::dmat4(viewMatrix(view.camera));
    camera.projection = glm::dmat4(projectionMatrix(
        view.camera, static_cast<float>(view.width) / static_cast<float>(view.height)));
    camera.width = view.width;
    camera.height = view.height;
    PictureSettings settings;
    settings.trace.rays = rays;
    settings.trace.radius = static_cast<double>(options.radius);
    settings.trace.falloff = options.falloff;
    settings.normals =
        view.normals == host::SceneNormals::Model ? NormalSource::Given : NormalSource::Geometric;
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(*scene, settings.trace);
    if (!tracer) {
        return badInput(tracer.status().message());
    }
    Result<Picture> picture = tracePicture(*scene, camera, settings, progress.callback());
    if (!picture) {
        return badInput(view.model.name + ": " + picture.status().message());
    }
    progress.pause();
    Truth truth;
    truth.visibility = FloatImage(picture->width, picture->height, 1);
    truth.visibility.pixels = std::move(picture->visibility);
    truth.standardError = FloatImage(picture->width, picture->height, 1);
    truth.standardError.pixels = std::move(picture->standardError);
    truth.noise = picture->noise;
    truth.rays = tracer->raysTraced();
    return truth;
}

} // namespace aolib::app
