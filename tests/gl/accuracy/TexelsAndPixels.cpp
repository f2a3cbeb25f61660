#include "TexelsAndPixels.h"

#include <cmath>

#include "content/Case.h"
#include "content/SceneSource.h"
#include "reference/PictureTracer.h"
#include "shared/cube_faces.h"

namespace aolib {

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr int kRays = 64;

double withoutNoise(double squares, std::size_t count, double noise) {
    const double mean = count > 0 ? squares / static_cast<double>(count) : 0.0;
    return std::sqrt(std::max(mean - noise * noise, 0.0));
}

/// The error of the texels behind the picture's pixels, each against rays from its own point.
double texelError(const RayScene& scene, const CubeMapImage& cube, const SmallHost& host,
                  const TraceSettings& settings) {
    std::vector<Receiver> receivers;
    std::vector<float> held;
    const glm::mat4 inverse = glm::inverse(host.projection() * host.view());
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const glm::vec2 ndc =
                2.0F * (glm::vec2(x, y) + 0.5F) / glm::vec2(kWidth, kHeight) - 1.0F;
            const glm::vec4 point = inverse * glm::vec4(ndc, 0.0F, 1.0F);
            const glm::vec3 direction = glm::vec3(point) / point.w - host.eye();
            const int face = shared::faceOf(direction);
            const glm::vec2 uv = shared::faceCoordinates(face, direction);
            const glm::ivec2 texel(uv * static_cast<float>(cube.faceSize));
            const auto index =
                static_cast<std::size_t>((texel.y * 6 + face) * cube.faceSize + texel.x);
            const glm::vec3 ray = shared::faceDirection(
                face, (glm::vec2(texel) + 0.5F) / static_cast<float>(cube.faceSize));
            const auto hit = scene.intersect(glm::dvec3(cube.position), glm::dvec3(ray));
            if (!hit || cube.distance[index] < 0.0F) {
                continue;
            }
            const bool away = glm::dot(hit->normal, glm::dvec3(ray)) > 0.0;
            receivers.push_back({hit->position, away ? -hit->normal : hit->normal, hit->clearance});
            held.push_back(cube.visibility[index]);
        }
    }
    const auto tracer = VisibilityTracer::create(scene, settings);
    const auto truth = tracer->trace(receivers);
    double squares = 0.0;
    for (std::size_t i = 0; i < held.size(); ++i) {
        squares += std::pow(held[i] - truth->visibility[i], 2);
    }
    return withoutNoise(squares, held.size(), truth->noise);
}

} // namespace

TexelsAndPixels measure(const gl::Functions& gl, const ProcAddressLoader& loader,
                        const AccuracyCase& view, Options options) {
    auto model = openScene(view.scene);
    EXPECT_TRUE(model.ok()) << model.error().sentence;
    const NamedCamera camera = camerasFor(view.scene, *model).at(view.camera);
    options.radius = view.radiusShare * model->bounds().diagonal();
    options.cubeMaps.place = false;
    if (view.ground) {
        addGround(*model, model->bounds().min.y);
    }
    SmallHost host(gl, loader, *model, options, kWidth, kHeight);
    host.useCamera(camera);
    const auto id = host.ao().addCubeMap(camera.eye);
    EXPECT_TRUE(id.ok()) << id.status().message();
    EXPECT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
    gl.Finish();
    EXPECT_TRUE(host.frame().ok());
    const VisibilityImage shown = host.visibility();
    const CubeMapImage cube = *host.ao().readCubeMap(*id);

    const auto scene = RayScene::create(model->flattened());
    EXPECT_TRUE(scene.ok()) << scene.status().message();
    PictureSettings settings;
    settings.trace.rays = kRays;
    settings.trace.radius = options.radius;
    const auto truth = tracePicture(
        *scene, {glm::dmat4(host.view()), glm::dmat4(host.projection()), kWidth, kHeight},
        settings);
    EXPECT_TRUE(truth.ok()) << truth.status().message();
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < shown.visibility.size(); ++i) {
        EXPECT_TRUE(std::isfinite(shown.visibility[i]));
        if (shown.visibility[i] >= 0.0F && truth->visibility[i] >= 0.0F) {
            squares += std::pow(shown.visibility[i] - truth->visibility[i], 2);
            ++count;
        }
    }
    return {texelError(*scene, cube, host, settings.trace),
            withoutNoise(squares, count, truth->noise),
            static_cast<double>(host.ao().statistics().coverage)};
}

} // namespace aolib
