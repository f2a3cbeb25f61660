#include "backbone/estimators/Estimators.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace aolib {

namespace {

/// The assumed depth as a share of the radius.
constexpr float kThicknessShare = 0.25F;

/// Rays of the first pass, after which a cube map is shown, and after the second; from then on each
/// pass doubles them. Their RMSE is about 0.03 and 0.01.
constexpr int kFirstRays = 16;
constexpr int kSecondRays = 64;

/// A step through n slices that visits all and spreads every few of them: coprime to n, near its
/// golden section.
int strideThrough(int n) {
    for (int step = static_cast<int>(0.618 * n); step > 1; --step) {
        if (std::gcd(step, n) == 1) {
            return step;
        }
    }
    return 1;
}

void setHorizonSplitUniforms(gl::GLSLShader& shader, const Options& options) {
    const HorizonSplitOptions& split = options.horizonSplit;
    shader.set("uDirections", split.directions);
    shader.set("uSteps", split.steps);
    shader.set("uStepSize", split.stepSize > 0.0F
                                ? split.stepSize
                                : options.radius / static_cast<float>(split.steps));
}

void setLayeredUniforms(gl::GLSLShader& shader, const Options& options) {
    const LayeredIntervalsOptions& layered = options.layeredIntervals;
    shader.set("uSlices", layered.slices);
    shader.set("uSliceStride", strideThrough(layered.slices));
    shader.set("uSteps", layered.steps);
    shader.set("uThickness", assumedThickness(options));
}

int passesOfRays(const Options& options) {
    int count = 1;
    while (raysAfter(options, count) < options.rayTraced.rays) {
        ++count;
    }
    return count;
}

const std::array<EstimatorTraits, 3> kEstimators{{
    {.estimator = Estimator::HorizonSplit,
     .shader = "horizon_split",
     .needsTracer = false,
     .layered = false,
     .noisy = true,
     .pages = PageKind::HiddenLayer,
     .refiner = RefinerKind::None,
     .refinerWithTracer = RefinerKind::None,
     .passes = [](const Options&) { return 1; },
     .setUniforms = setHorizonSplitUniforms,
     .sameOptions = [](const Options& a,
                       const Options& b) { return a.horizonSplit == b.horizonSplit; }},
    {.estimator = Estimator::LayeredIntervals,
     .shader = "layered_intervals",
     .needsTracer = false,
     .layered = true,
     .noisy = false,
     .pages = PageKind::HiddenLayer,
     .refiner = RefinerKind::Layered,
     .refinerWithTracer = RefinerKind::RayTraced,
     .passes = [](const Options& options) { return options.layeredIntervals.slices; },
     .setUniforms = setLayeredUniforms,
     .sameOptions = [](const Options& a,
                       const Options& b) { return a.layeredIntervals == b.layeredIntervals; }},
    {.estimator = Estimator::RayTraced,
     .shader = {},
     .needsTracer = true,
     .layered = false,
     .noisy = false,
     .pages = PageKind::Detail,
     .refiner = RefinerKind::None,
     .refinerWithTracer = RefinerKind::RayTraced,
     .passes = passesOfRays,
     .setUniforms = nullptr,
     .sameOptions = [](const Options& a, const Options& b) { return a.rayTraced == b.rayTraced; }},
}};

} // namespace

const EstimatorTraits& traitsOf(Estimator estimator) {
    return *std::ranges::find(kEstimators, estimator, &EstimatorTraits::estimator);
}

Estimator chosenEstimator(const Options& options, const Scene& scene, bool tracer) {
    if (options.estimator != Estimator::Automatic) {
        return options.estimator;
    }
    // Rays do not meet what a scene renderer draws.
    const bool traceable = options.backbone == Backbone::Cubemapped && tracer && !scene.drawn();
    return traceable ? Estimator::RayTraced : Estimator::LayeredIntervals;
}

float assumedThickness(const Options& options) {
    const float wanted = options.layeredIntervals.thickness;
    return wanted > 0.0F ? wanted : kThicknessShare * options.radius;
}

int raysAfter(const Options& options, int passes) {
    const int most = options.rayTraced.rays;
    int rays = passes == 0 ? 0 : passes == 1 ? kFirstRays : kSecondRays;
    for (int pass = 2; pass < passes && rays < most; ++pass) {
        rays *= 2;
    }
    return std::min(rays, most);
}

void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options) {
    shader.set("uRadius", options.radius);
    shader.set("uFalloff", static_cast<int>(options.falloff));
    if (const auto setUniforms = traitsOf(options.estimator).setUniforms) {
        setUniforms(shader, options);
    }
}

bool sameEstimate(const Options& a, const Options& b) {
    return a.estimator == b.estimator && a.falloff == b.falloff &&
           a.cubeMaps.faceSize == b.cubeMaps.faceSize && traitsOf(a.estimator).sameOptions(a, b);
}

} // namespace aolib
