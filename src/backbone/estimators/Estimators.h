#pragma once

#include <cstdint>
#include <string_view>

#include <aolib/Options.h>

#include "gl/GLSLShader.h"
#include "scene/Scene.h"

namespace aolib {

/// What the pages of tiles hold beside the texels of their face.
enum class PageKind : std::uint8_t {
    Detail,      ///< finer texels of the same surfaces
    HiddenLayer, ///< texels, as fine as the face's, of the surfaces behind others
};

/// What computes pixels of views at rest.
enum class RefinerKind : std::uint8_t { None, RayTraced, Layered };

/// All that the rooms read of an estimator: its row in the table of Estimators.cpp.
struct EstimatorTraits {
    Estimator estimator;
    /// NAME in the paths of its shaders, cubemap/visibility_NAME.frag and
    /// screenspace/visibility_NAME.frag; empty where a tracer computes it.
    std::string_view shader;
    bool needsTracer; ///< texels are traced by the host's tracer
    bool layered;     ///< captures layers of solid intervals, not the nearest surface alone
    bool noisy;       ///< its values must be blurred
    PageKind pages;
    RefinerKind refiner;           ///< without a tracer
    RefinerKind refinerWithTracer; ///< with one
    /// Passes over a tile until its estimate is complete.
    int (*passes)(const Options& options);
    /// Sets the uniforms that its shader reads beside uRadius and uFalloff; null for none.
    void (*setUniforms)(gl::GLSLShader& shader, const Options& options);
    /// Whether two sets of options give the same estimate, as far as its own options matter.
    bool (*sameOptions)(const Options& a, const Options& b);
};
/// @param estimator  not Estimator::Automatic
const EstimatorTraits& traitsOf(Estimator estimator);

/// Chooses the estimator where the options leave the choice. @param tracer  whether there is one
Estimator chosenEstimator(const Options& options, const Scene& scene, bool tracer);

/// Depth assumed of surfaces of which only the front is known, world units.
float assumedThickness(const Options& options);

/// Rays per texel after a number of passes of Estimator::RayTraced.
int raysAfter(const Options& options, int passes);

/// Sets the uniforms that the estimator's shader reads.
void setEstimatorUniforms(gl::GLSLShader& shader, const Options& options);

/// Whether two sets of options give the same estimate, apart from the radius.
bool sameEstimate(const Options& a, const Options& b);

} // namespace aolib
