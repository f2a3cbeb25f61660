// The lines of C++ that integration.md and troubleshooting.md show, as the compiler sees them;
// CheckSnippets.cmake compares.
#include <iostream>
#include <utility>

#include <aolib/aolib.h>

#include <aolib/RayTracing.h>

using aolib::TextureName;

void drawFace(const aolib::FaceView& face); // by the host: view, projection; depth is enough

void report(const aolib::AoStatus& status) {
    std::cerr << status.message() << '\n';
}

struct Host {
    aolib::AmbientOcclusion* ao;
    aolib::Options options;
    struct {
        glm::vec3 eye;
    } camera;
    glm::ivec2 size;
    std::uint32_t depth;
    glm::vec3 sceneMin, sceneMax, changedMin, changedMax;

    TextureName ownTextures();
    void ownShaders();
    void overManyFrames();
    void rays();
    void listen();
    void trust();
};

TextureName Host::ownTextures() {
    const auto factor = ao->aoApply({.size = size, .depth = TextureName{depth}}, camera.eye);
    return factor ? *factor : TextureName{};
}

void Host::ownShaders() {
    ao->setSceneRenderer(drawFace, sceneMin, sceneMax);
    ao->aoSceneChanged(changedMin, changedMax); // when something moved
}

void Host::overManyFrames() {
    options.frameBudget = 0.0F; // milliseconds per frame
}

void Host::rays() {
    auto tracer = aolib::createTexelTracer(); // workers: one per core but one, unless told
    if (tracer) {
        ao->setTexelTracer(std::move(*tracer)); // Estimator::Automatic, the default, takes it
    }
}

void Host::trust() {
    options.trust = {.programs = true, .textures = true, .raster = true};
    options.debugGroups = false; // the passes are not grouped for debuggers
}

void Host::listen() {
    ao->setMessageSink(report);
}
