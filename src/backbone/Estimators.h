#pragma once

#include <string_view>

#include <aolib/Options.h>

#include "gl/GLSLShader.h"

namespace aolib {

/// The estimator's name in the paths of its shaders: "horizon_split" of
/// cubemap/visibility_horizon_split.frag.
std::string_view estimatorShader(Estimator estimator);

/// Sets the uniforms that the estimator's shader reads. @param radius  in force, world units.
void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options, float radius);

} // namespace aolib
