#pragma once

#include <string_view>

#include <aolib/Options.h>

#include "gl/GLSLShader.h"
#include "scene/Scene.h"

namespace aolib {

/// What the rooms need to know of an estimator: one line each in Estimators.cpp.
struct EstimatorTraits {
    std::string_view shader; ///< in the paths of its shaders: cubemap/visibility_<shader>.frag
    bool layered; ///< reads layers of solid intervals instead of the nearest surface alone
};
EstimatorTraits traitsOf(Estimator estimator);

/// The estimator in force where the options leave the choice.
/// @param tracer  whether the host gave one.
Estimator chosenEstimator(const Options& options, const Scene& scene, bool tracer);

/// Depth assumed of surfaces of which nothing but the front is known, world units.
float assumedThickness(const Options& options);

/// Sets the uniforms that the estimator's shader reads.
void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options);

/// Whether two sets of options give the same estimate, but for the radius.
bool sameEstimate(const Options& a, const Options& b);

} // namespace aolib
