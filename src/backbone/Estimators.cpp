#include "backbone/Estimators.h"

#include <numeric>

namespace aolib {

namespace {

/// The assumed depth as a share of the radius.
constexpr float kThicknessShare = 0.25F;

/// A step through n slices that visits all and spreads every few of them: coprime to n, near its
/// golden section.
int strideOf(int n) {
    for (int step = static_cast<int>(0.618 * n); step > 1; --step) {
        if (std::gcd(step, n) == 1) {
            return step;
        }
    }
    return 1;
}

} // namespace

EstimatorTraits traitsOf(Estimator estimator) {
    switch (estimator) {
    case Estimator::Automatic: // never in force
        break;
    case Estimator::HorizonSplit:
        return {"horizon_split", false};
    case Estimator::LayeredIntervals:
        return {"layered_intervals", true};
    case Estimator::RayTraced:
        return {"", false};
    }
    return {};
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

void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options) {
    shader.set("uRadius", options.radius);
    shader.set("uFalloff", static_cast<int>(options.falloff));
    if (options.estimator == Estimator::LayeredIntervals) {
        const LayeredIntervalsOptions& layered = options.layeredIntervals;
        shader.set("uSlices", layered.slices);
        shader.set("uSliceStride", strideOf(layered.slices));
        shader.set("uSteps", layered.steps);
        shader.set("uThickness", assumedThickness(options));
        return;
    }
    const HorizonSplitOptions& split = options.horizonSplit;
    shader.set("uDirections", split.directions);
    shader.set("uSteps", split.steps);
    shader.set("uStepSize", split.stepSize > 0.0F
                                ? split.stepSize
                                : options.radius / static_cast<float>(split.steps));
}

bool sameEstimate(const Options& a, const Options& b) {
    return a.estimator == b.estimator && a.falloff == b.falloff &&
           a.horizonSplit == b.horizonSplit && a.layeredIntervals == b.layeredIntervals &&
           a.rayTraced == b.rayTraced && a.cubeMaps.faceSize == b.cubeMaps.faceSize;
}

} // namespace aolib
