// A small host renderer with ambient occlusion: a camera circles a ground with a few boxes.
// The lines between the two marks are all there is of aolib; the README shows them.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "Boxes.h"
#include "Display.h"
#include "Renderer.h"

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 540;
constexpr int kUntilClosed = std::numeric_limits<int>::max();

struct Camera {
    glm::vec3 eye;
    glm::mat4 view;
    glm::mat4 projection;
};

/// The camera of a frame: once round in ten seconds at 60 frames a second.
Camera orbit(int frame) {
    const float angle = glm::radians(0.6F * static_cast<float>(frame) + 30.0F);
    const glm::vec3 eye(7.5F * glm::sin(angle), 4.0F, 7.5F * glm::cos(angle));
    constexpr float kAspect = static_cast<float>(kWidth) / static_cast<float>(kHeight);
    return {eye, glm::lookAt(eye, {0.0F, 0.6F, 0.0F}, {0.0F, 1.0F, 0.0F}),
            glm::perspective(glm::radians(45.0F), kAspect, 0.1F, 100.0F)};
}

} // namespace

// [aolib]
#include <aolib/RayTracing.h>
#include <aolib/aolib.h>

std::string drawFrames(Display& display, const Renderer& renderer, const Triangles& scene, int n) {
    auto ao = aolib::AmbientOcclusion::create(display.getProcAddress(), {.radius = 1.5F});
    if (!ao) {
        return ao.status().message();
    }
    auto tracer = aolib::createTexelTracer(); // rays, on the processor's other cores
    ao->setTexelTracer(tracer ? std::move(*tracer) : nullptr); // without one the GPU computes
    const auto mesh = ao->addMesh({scene.positions, scene.normals, scene.indices});
    for (int i = 0; mesh && display.open() && (i < n || !ao->statistics().converged); ++i) {
        const Camera camera = orbit(std::min(i, n - 1));
        ao->aoSetCamera(camera.view, camera.projection);
        ao->aoDrawBegin();
        renderer.draw(camera.view, camera.projection); // as ever, to the host's own framebuffer
        ao->aoDrawEnd(camera.eye.x, camera.eye.y, camera.eye.z);
        display.show();
    }
    return ao->lastStatus().message(); // of the latest failure; empty if all went well
}
// [/aolib]

namespace {

struct Arguments {
    bool headless = false;
    std::optional<int> frames;
    std::string screenshot;
};

std::optional<Arguments> parse(int argc, char** argv) {
    Arguments arguments;
    for (int i = 1; i < argc; ++i) {
        const std::string flag = argv[i];
        if (flag == "--headless") {
            arguments.headless = true;
        } else if (flag == "--frames" && i + 1 < argc && std::atoi(argv[i + 1]) > 0) {
            arguments.frames = std::atoi(argv[++i]);
        } else if (flag == "--screenshot" && i + 1 < argc) {
            arguments.screenshot = argv[++i];
        } else {
            return std::nullopt;
        }
    }
    if (!arguments.screenshot.empty() && !arguments.headless) {
        return std::nullopt;
    }
    return arguments;
}

std::string run(const Arguments& arguments) {
    std::string failure;
    const auto display = arguments.headless ? Display::openOffscreen(kWidth, kHeight, failure)
                                            : Display::openWindow(kWidth, kHeight, failure);
    if (!display) {
        return failure;
    }
    const Triangles scene = groundWithBoxes();
    const Renderer renderer(display->getProcAddress(), scene, kWidth, kHeight);
    const int frames = arguments.frames.value_or(arguments.headless ? 1 : kUntilClosed);
    failure = drawFrames(*display, renderer, scene, frames);
    if (failure.empty() && !arguments.screenshot.empty() && !renderer.save(arguments.screenshot)) {
        return arguments.screenshot + " cannot be written";
    }
    return failure;
}

} // namespace

int main(int argc, char** argv) {
    const std::optional<Arguments> arguments = parse(argc, argv);
    if (!arguments) {
        std::cerr << "Usage: example_01_minimal [--frames N]\n"
                     "       example_01_minimal --headless [--frames N] [--screenshot FILE.ppm]\n";
        return 2;
    }
    std::string failure;
    try {
        failure = run(*arguments);
    } catch (const std::exception& error) {
        failure = error.what();
    }
    if (!failure.empty()) {
        std::cerr << "example_01_minimal: " << failure << '\n';
    }
    return failure.empty() ? 0 : 1;
}
