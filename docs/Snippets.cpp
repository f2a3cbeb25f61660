// The lines of C++ that integration.md and troubleshooting.md show, as the compiler sees them;
// CheckSnippets.cmake compares.
#include <iostream>
#include <utility>
#include <vector>

#include <aolib/aolib.h>

#include <aolib/RayTracing.h>

using aolib::TextureName;

void drawFace(const aolib::FaceView& face); // by the host: view, projection; depth is enough

struct View {
    std::uint32_t number;
    int x, y, width, height;
    glm::mat4 view, projection;
};
void glViewport(int x, int y, int width, int height);
void draw(const View& view);
void drawBar(float progress);
bool userGaveUp();

bool showProgress(float progress) { // 0 to 1; false cancels
    drawBar(progress);
    return !userGaveUp();
}

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
    void severalViews(const std::vector<View>& views);
    void loadingScreen(const std::vector<glm::vec3>& positions);
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

void Host::severalViews(const std::vector<View>& views) {
    for (const View& v : views) {
        glViewport(v.x, v.y, v.width, v.height);
        draw(v);
        ao->aoShade(v.view, v.projection, aolib::ViewId{v.number});
    }
}

void Host::loadingScreen(const std::vector<glm::vec3>& positions) {
    ao->prepare(showProgress, positions); // places cube maps there and computes them whole
}

void Host::trust() {
    options.trust = {.programs = true, .textures = true, .raster = true};
    options.debugGroups = false; // the passes are not grouped for debuggers
}

void Host::listen() {
    ao->setMessageSink(report);
}
