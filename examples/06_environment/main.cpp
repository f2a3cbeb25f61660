// Boxes under an evening sky, bright on one side: visibility and bent normals of vertices are
// baked, then a cone of open directions says how much of which part of the sky arrives.
//
// aolib: 23 lines, between the marks.
#include <algorithm>
#include <exception>
#include <optional>

#include "LitHost.h"
#include "Offscreen.h"
#include "Stage.h"

// [aolib]
#include <aolib/bake/AbstractBaker.h>
#include <aolib/lighting/EnvironmentLight.h>
// [/aolib]

namespace {

constexpr float kLongestEdge = 0.12F; // world units

/// Blue all round, a wide glow towards +x +z.
std::vector<glm::vec3> eveningSky(int width, int height) {
    std::vector<glm::vec3> sky;
    for (int y = 0; y < height; ++y) {
        const float up = (static_cast<float>(y) + 0.5F) / static_cast<float>(height) - 0.5F;
        for (int x = 0; x < width; ++x) {
            // Columns go from -x over -z, +x and +z round to -x.
            const float turn = (static_cast<float>(x) + 0.5F) / static_cast<float>(width) - 0.625F;
            const float away = 40.0F * (turn * turn + 0.5F * up * up);
            sky.push_back(up < 0.0F
                              ? glm::vec3(0.08F)
                              : glm::vec3(0.35F, 0.50F, 0.80F) +
                                    glm::vec3(4.0F, 2.2F, 0.8F) * std::max(0.0F, 1.0F - away));
        }
    }
    return sky;
}

int run(const stage::Arguments& arguments) {
    const auto context = stage::openContext(aolib::ContextRequest::Profile::Core);
    const Triangles scene = cutFine(groundWithBoxes(), kLongestEdge);
    const stage::Camera camera = stage::camera();
    const glm::mat4 worldToClip = camera.projection * camera.view;
    std::vector<glm::vec4> open; // without ambient occlusion everything is
    for (const glm::vec3& normal : scene.normals) {
        open.emplace_back(normal, 1.0F);
    }
    // [aolib]
    if (arguments.ambientOcclusion) {
        aolib::bake::BakeScene input;
        input.surfaces.push_back({scene.positions, scene.normals, {}, scene.indices, 0});
        const auto baker = aolib::bake::createRayBaker(std::move(input), {.rays = 64});
        aolib::bake::VertexOptions fit;
        fit.fit = aolib::bake::VertexFit::LeastSquares; // smooth where walls meet the ground
        const auto baked = baker ? (*baker)->bakeVertices(fit, {}) : baker.status();
        if (!baked) {
            return stage::fail(baked.status().message());
        }
        for (std::size_t i = 0; i < open.size(); ++i) {
            open[i] = glm::vec4((*baked)[0].bentNormal[i], (*baked)[0].visibility[i]);
        }
    }
    const auto light =
        aolib::lighting::EnvironmentLight::create(context->loader(), {64, 32, eveningSky(64, 32)});
    if (!light) {
        return stage::fail(light.status().message());
    }
    const LitHost host(scene, open, aolib::lighting::environmentShader());
    host.draw(worldToClip, static_cast<GLuint>(light->cones()));
    // [/aolib]
    return stage::save(arguments.picture, LitHost::read());
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
