#include "bench/environment/EnvironmentRun.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "bench/environment/PixelLight.h"
#include "bench/environment/TracedLight.h"
#include "image/Compose.h"
#include "image/ToneMap.h"
#include "raytracing/RayScene.h"
#include "reference/EnvironmentTracer.h"
#include "reference/OpeningTracer.h"

namespace aolib::bench {

namespace {

using host::LitMethod;
using Clock = std::chrono::steady_clock;

constexpr std::array<LitMethod, 6> kPixelMethods{LitMethod::Irradiance, LitMethod::Blurred,
                                                 LitMethod::Cone,       LitMethod::ConeAndSun,
                                                 LitMethod::Sectors,    LitMethod::SectorsAndSun};
constexpr std::array<LitMethod, 7> kDrawnMethods{
    LitMethod::Irradiance, LitMethod::Blurred, LitMethod::BlurredByAngles, LitMethod::Cone,
    LitMethod::ConeAndSun, LitMethod::Sectors, LitMethod::SectorsAndSun};
/// Of the truth's mean: what is that bright is shown at 63%.
constexpr double kShownMean = 1.0;

double meanOf(std::span<const glm::vec3> light) {
    double sum = 0.0;
    for (const glm::vec3& value : light) {
        sum += (double{value.r} + double{value.g} + double{value.b}) / 3.0;
    }
    return light.empty() ? 0.0 : sum / double(light.size());
}

/// Over receivers that a drawn picture shows, too.
void compare(EnvironmentRow& row, std::span<const glm::vec3> light, const LightList& truth,
             std::span<const std::uint8_t> shown) {
    double squares = 0.0;
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (!shown.empty() && shown[i] == 0) {
            continue;
        }
        const glm::dvec3 error = glm::dvec3(light[i]) - glm::dvec3(truth.radiance[i]);
        squares += glm::dot(error, error) / 3.0;
        sum += (error.r + error.g + error.b) / 3.0;
        ++count;
    }
    const double mean = meanOf(truth.radiance);
    row.rmse = std::sqrt(squares / double(count)) / mean;
    row.bias = sum / double(count) / mean;
    row.noise = truth.noise / mean;
}

/// A view that is drawn and traced.
class ViewRun {
public:
    ViewRun(const EnvironmentPlan& plan, const EnvironmentView& view, const gl::Functions& gl,
            const ProcAddressLoader& loader)
        : plan_(plan), view_(view), gl_(gl), loader_(loader) {}

    AoStatus open();
    AoStatus measure(const NamedEnvironment& environment, EnvironmentFigures& figures);

private:
    AoStatus drawn(LitMethod method, const LightList& truth, EnvironmentRow& row);

    const EnvironmentPlan& plan_;
    const EnvironmentView& view_;
    const gl::Functions& gl_;
    const ProcAddressLoader& loader_;
    std::optional<RayScene> scene_;
    std::optional<host::LitRenderer> renderer_;
    LitPixels pixels_;
    std::vector<Opening> openings_;
    FloatImage picture_; ///< the one drawn last
};

AoStatus ViewRun::open() {
    Result<RayScene> scene = RayScene::create(view_.scene.mesh());
    if (!scene) {
        return scene.status();
    }
    scene_ = std::move(*scene);
    Result<LitPixels> pixels = litPixels(*scene_, view_.camera, plan_.width, plan_.height);
    if (!pixels) {
        return pixels.status();
    }
    pixels_ = std::move(*pixels);
    if (pixels_.receivers.empty()) {
        return {StatusCode::NoScene, view_.scene.name + ": the camera sees no surface"};
    }
    constexpr std::uint64_t seed = 1; // not the truth's
    openings_ = traceOpenings(*scene_, pixels_.receivers, plan_.openingRays, seed);
    std::vector<host::LitPiece> pieces = view_.scene.pieces;
    for (host::LitPiece& piece : pieces) {
        piece.colour = glm::vec3(1.0F);
    }
    Result<host::LitRenderer> renderer =
        host::LitRenderer::create(gl_, pieces, {plan_.width, plan_.height});
    if (!renderer) {
        return renderer.status();
    }
    renderer_ = std::move(*renderer);
    return {};
}

AoStatus ViewRun::drawn(LitMethod method, const LightList& truth, EnvironmentRow& row) {
    const glm::mat4 view = viewMatrix(view_.camera);
    const glm::mat4 projection = projectionMatrix(
        view_.camera, static_cast<float>(plan_.width) / static_cast<float>(plan_.height));
    std::vector<double> times;
    for (int frame = 0; frame <= plan_.frames; ++frame) {
        gl_.Finish();
        const Clock::time_point begin = Clock::now();
        renderer_->draw(view, projection, method);
        gl_.Finish();
        if (frame > 0) { // the first one also compiles
            times.push_back(
                std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
        }
    }
    std::sort(times.begin(), times.end());
    row.frameMs = times.empty() ? 0.0 : times[times.size() / 2];
    host::LitRenderer::Picture picture = renderer_->read();
    std::vector<glm::vec3> light;
    std::vector<std::uint8_t> shown;
    for (const std::size_t place : pixels_.places) {
        const float* rgb = &picture.radiance.pixels[3 * place];
        light.emplace_back(rgb[0], rgb[1], rgb[2]);
        shown.push_back(picture.covered[place]);
    }
    compare(row, light, truth, shown);
    picture_ = std::move(picture.radiance);
    return {};
}

AoStatus ViewRun::measure(const NamedEnvironment& environment, EnvironmentFigures& figures) {
    LightSettings settings;
    settings.rays = plan_.truthRays;
    Result<LightList> truth =
        traceEnvironment(*scene_, environment.map, pixels_.receivers, settings);
    if (!truth) {
        return truth.status();
    }
    if (AoStatus status = renderer_->setEnvironment(loader_, environment.map); !status) {
        return status;
    }
    EnvironmentRow row;
    row.scene = view_.scene.name;
    row.environment = environment.name;
    for (const LitMethod method : kPixelMethods) {
        const auto light = lightOf(*scene_, pixels_.receivers, openings_, environment.map, method);
        if (!light) {
            return light.status();
        }
        row.method = method;
        compare(row, *light, *truth, {});
        figures.rows.push_back(row);
    }
    row.drawn = true;
    const float exposure = static_cast<float>(kShownMean / meanOf(truth->radiance));
    std::vector<ByteImage> strip;
    for (const LitMethod method : kDrawnMethods) {
        row.method = method;
        if (AoStatus status = drawn(method, *truth, row); !status) {
            return status;
        }
        figures.rows.push_back(row);
        if (method != LitMethod::BlurredByAngles && method != LitMethod::Sectors) {
            strip.push_back(toneMapped(picture_, exposure));
        }
    }
    TracedLight{pixels_, std::move(*truth)}.paint(picture_);
    strip.insert(strip.begin(), toneMapped(picture_, exposure));
    const Result<ByteImage, ImageError> beside = sideBySide(strip);
    if (!beside) {
        return {StatusCode::OutOfMemory, beside.error().message};
    }
    figures.strips.push_back({row.scene, row.environment, *beside});
    return {};
}

} // namespace

const char* litMethodName(LitMethod method) {
    switch (method) {
    case LitMethod::Irradiance:
        return "irradiance";
    case LitMethod::Blurred:
        return "blurred";
    case LitMethod::BlurredByAngles:
        return "blurred-by-angles";
    case LitMethod::Cone:
        return "cone";
    case LitMethod::ConeAndSun:
        return "cone-and-sun";
    case LitMethod::Sectors:
        return "sectors";
    case LitMethod::SectorsAndSun:
        return "sectors-and-sun";
    }
    return "unknown";
}

Result<EnvironmentFigures>
runEnvironmentPlan(const EnvironmentPlan& plan, const gl::Functions& gl,
                   const ProcAddressLoader& loader,
                   const std::function<bool(const std::string& next, double done)>& tell) {
    EnvironmentFigures figures;
    const double all = double(plan.views.size() * plan.environments.size());
    for (const EnvironmentView& view : plan.views) {
        if (!tell(view.scene.name + ", openings", double(figures.strips.size()) / all)) {
            return figures;
        }
        ViewRun run(plan, view, gl, loader);
        if (AoStatus status = run.open(); !status) {
            return AoStatus(status.code(), view.scene.name + ": " + status.message());
        }
        for (const NamedEnvironment& environment : plan.environments) {
            const std::string what = view.scene.name + ", " + environment.name;
            if (!tell(what, double(figures.strips.size()) / all)) {
                return figures;
            }
            if (AoStatus status = run.measure(environment, figures); !status) {
                return AoStatus(status.code(), what + ": " + status.message());
            }
        }
    }
    return figures;
}

} // namespace aolib::bench
