// A host on Windows: a hidden window and a context of WGL's. It draws what 05_offscreen_osmesa
// draws.
//
// aolib: 15 lines, between the marks. HiddenWindow::getProcAddress shows what WGL needs.
#include <exception>

#include "HiddenWindow.h"
#include "Renderer.h"
#include "Stage.h"

// [aolib]
#include <aolib/aolib.h>
// [/aolib]

namespace {

int run(const stage::Arguments& arguments) {
    std::string reason;
    const auto window = HiddenWindow::open(stage::kWidth, stage::kHeight, reason);
    if (!window) {
        return stage::fail("NOT TESTED: " + reason);
    }
    const Triangles scene = groundWithBoxes();
    const Renderer renderer(HiddenWindow::getProcAddress, scene, stage::kWidth, stage::kHeight);
    const stage::Camera camera = stage::camera();
    if (!arguments.ambientOcclusion) {
        renderer.draw(camera.view, camera.projection);
    } else {
        // [aolib]
        auto ao = aolib::AmbientOcclusion::create(HiddenWindow::getProcAddress,
                                                  {.estimator = aolib::Estimator::LayeredIntervals,
                                                   .radius = 1.5F,
                                                   .frameBudget = 0.0F,
                                                   .cubeMaps = {.faceSize = 256}});
        if (!ao || !ao->addMesh({scene.positions, scene.normals, scene.indices})) {
            return stage::fail(ao ? ao->lastStatus().message() : ao.status().message());
        }
        ao->aoSetCamera(camera.view, camera.projection);
        ao->aoDrawBegin();
        renderer.draw(camera.view, camera.projection);
        if (!ao->aoDrawEnd(camera.eye.x, camera.eye.y, camera.eye.z)) {
            return stage::fail(ao->lastStatus().message());
        }
        // [/aolib]
    }
    return renderer.save(arguments.picture) ? 0
                                            : stage::fail(arguments.picture + " cannot be written");
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
