// A host without a window, a display or a graphics card: Mesa draws into the program's own memory.
//
// aolib: 15 lines, between the marks.
#include <exception>

#include "Renderer.h" // its header of OpenGL before OSMesa's older one

#include <GL/osmesa.h>

#include "Stage.h"

// [aolib]
#include <aolib/aolib.h>
// [/aolib]

namespace {

void* loadFunction(const char* name) {
    return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
}

int run(const stage::Arguments& arguments) {
    constexpr std::size_t kPixels = static_cast<std::size_t>(stage::kWidth * stage::kHeight);
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              24,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    std::vector<std::uint8_t> rgba(4 * kPixels); // framebuffer 0
    if (context == nullptr || OSMesaMakeCurrent(context, rgba.data(), GL_UNSIGNED_BYTE,
                                                stage::kWidth, stage::kHeight) == GL_FALSE) {
        return stage::fail("NOT TESTED: OSMesa gives no core context");
    }
    const Triangles scene = groundWithBoxes();
    const Renderer renderer(loadFunction, scene, stage::kWidth, stage::kHeight);
    const stage::Camera camera = stage::camera();
    if (!arguments.ambientOcclusion) {
        renderer.draw(camera.view, camera.projection);
    } else {
        // [aolib]
        auto ao = aolib::AmbientOcclusion::create(loadFunction,
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
    reinterpret_cast<void (*)()>(loadFunction("glFinish"))();
    std::vector<std::uint8_t> rgb;
    for (std::size_t i = 0; i < kPixels; ++i) {
        rgb.insert(rgb.end(), {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]});
    }
    OSMesaDestroyContext(context);
    return stage::save(arguments.picture, rgb);
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
