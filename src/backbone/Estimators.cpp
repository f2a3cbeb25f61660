#include "backbone/Estimators.h"

namespace aolib {

namespace {

/// Depth that screen space assumes of what it sees, as a share of the radius.
constexpr float kThicknessShare = 0.25F;

} // namespace

EstimatorTraits traitsOf(Estimator estimator) {
    switch (estimator) {
    case Estimator::HorizonSplit:
        return {"horizon_split", false};
    case Estimator::LayeredIntervals:
        return {"layered_intervals", true};
    }
    return {};
}

void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options, float radius) {
    shader.set("uRadius", radius);
    shader.set("uFalloff", static_cast<int>(options.falloff));
    if (options.estimator == Estimator::LayeredIntervals) {
        const LayeredIntervalsOptions& layered = options.layeredIntervals;
        shader.set("uSlices", layered.slices);
        shader.set("uSteps", layered.steps);
        shader.set("uThickness",
                   layered.thickness > 0.0F ? layered.thickness : kThicknessShare * radius);
        return;
    }
    const HorizonSplitOptions& split = options.horizonSplit;
    shader.set("uDirections", split.directions);
    shader.set("uSteps", split.steps);
    shader.set("uStepSize",
               split.stepSize > 0.0F ? split.stepSize : radius / static_cast<float>(split.steps));
}

bool sameEstimate(const Options& a, const Options& b) {
    return a.estimator == b.estimator && a.falloff == b.falloff &&
           a.horizonSplit == b.horizonSplit && a.layeredIntervals == b.layeredIntervals &&
           a.cubeMaps.faceSize == b.cubeMaps.faceSize;
}

} // namespace aolib
