#pragma once

#include <string_view>

#include <aolib/Options.h>

#include "gl/GLSLShader.h"

namespace aolib {

/// What the rooms need to know of an estimator: one line each in Estimators.cpp.
struct EstimatorTraits {
    std::string_view shader; ///< in the paths of its shaders: cubemap/visibility_<shader>.frag
    bool layered; ///< reads layers of solid intervals instead of the nearest surface alone
};
EstimatorTraits traitsOf(Estimator estimator);

/// Sets the uniforms that the estimator's shader reads. @param radius  in force, world units.
void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options, float radius);

/// Whether two sets of options give the same estimate, but for the radius.
bool sameEstimate(const Options& a, const Options& b);

} // namespace aolib
