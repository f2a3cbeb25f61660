#include "backbone/Estimators.h"

namespace aolib {

std::string_view estimatorShader(Estimator estimator) {
    switch (estimator) {
    case Estimator::HorizonSplit:
        return "horizon_split";
    }
    return {};
}

void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options, float radius) {
    const HorizonSplitOptions& split = options.horizonSplit;
    shader.set("uRadius", radius);
    shader.set("uFalloff", static_cast<int>(options.falloff));
    shader.set("uDirections", split.directions);
    shader.set("uSteps", split.steps);
    shader.set("uStepSize",
               split.stepSize > 0.0F ? split.stepSize : radius / static_cast<float>(split.steps));
}

} // namespace aolib
