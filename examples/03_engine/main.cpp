// A deferred renderer: aolib gets its depth and normals and gives a texture, which the lighting
// pass multiplies the sky's light by. The sun is as bright as ever.
//
// aolib: 18 lines, between the marks.
#include <exception>

#include "Engine.h"
#include "Offscreen.h"
#include "Stage.h"

// [aolib]
#include <aolib/aolib.h>
// [/aolib]

namespace {

int run(const stage::Arguments& arguments) {
    const auto context = stage::openContext(aolib::ContextRequest::Profile::Core);
    const Triangles scene = groundWithBoxes();
    const Engine engine(scene, stage::kWidth, stage::kHeight);
    const stage::Camera camera = stage::camera();
    engine.drawGeometry(camera.view, camera.projection);
    if (!arguments.ambientOcclusion) {
        engine.light(engine.white());
        return stage::save(arguments.picture, engine.read());
    }
    // [aolib]
    auto ao = aolib::AmbientOcclusion::create(context->loader(),
                                              {.estimator = aolib::Estimator::LayeredIntervals,
                                               .radius = 1.5F,
                                               .frameBudget = 0.0F,
                                               .cubeMaps = {.faceSize = 256}});
    if (!ao || !ao->addMesh({scene.positions, scene.normals, scene.indices})) {
        return stage::fail(ao ? ao->lastStatus().message() : ao.status().message());
    }
    ao->aoSetCamera(camera.view, camera.projection);
    const auto factor = ao->aoApply({.size = {stage::kWidth, stage::kHeight},
                                     .depth = aolib::TextureName{engine.depth()},
                                     .normal = aolib::TextureName{engine.normal()}},
                                    camera.eye);
    if (!factor) {
        return stage::fail(factor.status().message());
    }
    engine.light(static_cast<GLuint>(*factor));
    // [/aolib]
    return stage::save(arguments.picture, engine.read());
}

} // namespace

int main(int argc, char** argv) {
    const stage::Arguments arguments = stage::parse(argc, argv);
    if (arguments.picture.empty()) {
        return 2;
    }
    try {
        return run(arguments);
    } catch (const std::exception& error) {
        return stage::fail(error.what());
    }
}
