#include "bench/environment/TracedLight.h"

#include <utility>

#include <glm/geometric.hpp>

#include "reference/PictureTracer.h"

namespace aolib::bench {

namespace {

/// The colour of each triangle of LitScene::mesh().
std::vector<glm::vec3> coloursOf(const LitScene& scene) {
    std::vector<glm::vec3> colours;
    for (const host::LitPiece& piece : scene.pieces) {
        colours.insert(colours.end(), piece.indices.size() / 3, piece.colour);
    }
    return colours;
}

} // namespace

Result<LitPixels> litPixels(const RayScene& scene, const NamedCamera& camera, int width,
                            int height) {
    PictureCamera view;
    view.view = glm::dmat4(viewMatrix(camera));
    view.projection = glm::dmat4(
        projectionMatrix(camera, static_cast<float>(width) / static_cast<float>(height)));
    view.width = width;
    view.height = height;
    PictureSettings settings;
    settings.trace.rays = 2; // the surfaces alone are wanted
    settings.trace.falloff = Falloff::Off;
    settings.normals = NormalSource::Given;
    settings.surfaces = true;
    const Result<Picture> picture = tracePicture(scene, view, settings);
    if (!picture) {
        return picture.status();
    }
    LitPixels pixels;
    for (std::size_t i = 0; i < picture->depth.size(); ++i) {
        if (picture->depth[i] >= 0.0F) {
            pixels.receivers.push_back({glm::dvec3(picture->position[i]),
                                        glm::normalize(glm::dvec3(picture->normal[i])), -1.0});
            pixels.places.push_back(i);
            pixels.triangles.push_back(picture->triangle[i]);
        }
    }
    return pixels;
}

void TracedLight::paint(FloatImage& picture) const {
    for (std::size_t i = 0; i < pixels.places.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            picture.pixels[3 * pixels.places[i] + static_cast<std::size_t>(channel)] =
                light.radiance[i][channel];
        }
    }
}

Result<TracedLight> traceLight(const LitScene& scene, const lighting::EnvironmentMap& map,
                               const NamedCamera& camera, int width, int height, int rays,
                               const LoopProgress& progress) {
    const Result<RayScene> rayScene = RayScene::create(scene.mesh());
    if (!rayScene) {
        return rayScene.status();
    }
    Result<LitPixels> pixels = litPixels(*rayScene, camera, width, height);
    if (!pixels) {
        return pixels.status();
    }
    LightSettings settings;
    settings.rays = rays;
    Result<LightList> light =
        traceEnvironment(*rayScene, map, pixels->receivers, settings, progress);
    if (!light) {
        return light.status();
    }
    const std::vector<glm::vec3> colours = coloursOf(scene);
    for (std::size_t i = 0; i < pixels->places.size(); ++i) {
        light->radiance[i] *= colours[pixels->triangles[i]];
    }
    return TracedLight{std::move(*pixels), std::move(*light)};
}

} // namespace aolib::bench
