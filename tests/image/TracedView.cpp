#include "TracedView.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "shared/cube_faces.h"

namespace aolib::test {

namespace {

/// How far the distance that a texel holds may lie from a pixel's, as a share of it, for both to be
/// one surface. At 512 texels a face, a texel spans 0.4% of the distance on a facing surface.
constexpr float kSameSurface = 0.02F;

} // namespace

Picture traceView(const Model& model, const NamedCamera& camera, int width, int height,
                  float radius, int rays, NormalSource normals) {
    Result<RayScene> scene = RayScene::create(model.flattened());
    if (!scene) {
        ADD_FAILURE() << scene.status().message();
        return {};
    }
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    PictureCamera view;
    view.view = glm::dmat4(viewMatrix(camera));
    view.projection = glm::dmat4(projectionMatrix(camera, aspect));
    view.width = width;
    view.height = height;
    PictureSettings settings;
    settings.trace.rays = rays;
    settings.trace.radius = static_cast<double>(radius);
    settings.surfaces = true;
    settings.normals = normals;
    Result<Picture> picture = tracePicture(*scene, view, settings);
    if (!picture) {
        ADD_FAILURE() << picture.status().message();
        return {};
    }
    return std::move(*picture);
}

FloatImage visibilityOf(const Picture& picture) {
    FloatImage image(picture.width, picture.height, 1);
    image.pixels = picture.visibility;
    return image;
}

FloatImage texelsAt(const CubeMapImage& cubeMap, const Picture& picture) {
    FloatImage image(picture.width, picture.height, 1, backgroundValue);
    const int size = cubeMap.faceSize;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (picture.visibility[i] < 0.0F) {
            continue;
        }
        const glm::vec3 direction = picture.position[i] - cubeMap.position;
        const int face = shared::faceOf(direction);
        const glm::vec2 uv = shared::faceCoordinates(face, direction);
        const int x = std::clamp(static_cast<int>(uv.x * static_cast<float>(size)), 0, size - 1);
        const int y = std::clamp(static_cast<int>(uv.y * static_cast<float>(size)), 0, size - 1);
        // Six faces side by side: rows are six faces long.
        const auto texel = static_cast<std::size_t>((y * 6 + face) * size + x);
        const float distance = glm::length(direction);
        if (std::abs(cubeMap.distance[texel] - distance) < kSameSurface * distance) {
            image.pixels[i] = cubeMap.visibility[texel];
        }
    }
    return image;
}

double shareOfSurface(const FloatImage& test, const FloatImage& reference) {
    double surface = 0.0;
    double both = 0.0;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
        if (reference.pixels[i] >= 0.0F) {
            surface += 1.0;
            both += test.pixels[i] >= 0.0F ? 1.0 : 0.0;
        }
    }
    return both / surface;
}

double rmse(const FloatImage& test, const FloatImage& reference) {
    const Result<Metrics, ImageError> metrics = compareImages(test, reference);
    EXPECT_TRUE(metrics.ok()) << metrics.error().message;
    return metrics ? metrics->rmse : 1.0;
}

} // namespace aolib::test
