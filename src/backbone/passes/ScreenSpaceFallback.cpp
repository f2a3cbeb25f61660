#include "backbone/passes/ScreenSpaceFallback.h"

#include <utility>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

constexpr int kFallbackDepthUnit = 0;
constexpr int kMaskUnit = 1;
constexpr int kSides = 8; ///< half slices
constexpr int kSteps = 8; ///< of each
/// Assumed depth of visible surfaces, in radii, where no option says another (docs/accuracy.md
/// has the errors of others).
constexpr float kFallbackThickness = 0.5F;

/// Share of the surfaces that cube maps shade below which it is too dear for a software rasteriser
/// within a budget.
constexpr float kLeastInSoftware = 0.5F;

} // namespace

bool ScreenSpaceFallback::due(const BackboneContext& context, float shaded, bool atOnce) {
    const bool dear = context.gl.capabilities.software && shaded < kLeastInSoftware;
    return context.options.cubeMaps.screenSpaceFallback && !context.scene.empty() &&
           shaded < 1.0F && (!dear || atOnce);
}

Result<ScreenSpaceFallback> ScreenSpaceFallback::create(const BackboneContext& context) {
    auto visibility =
        buildShader(context.gl, "fullscreen.vert", "cubemap/screen_space_fallback.frag");
    if (!visibility) {
        return visibility.status();
    }
    ScreenSpaceFallback fallback;
    fallback.visibility_ = std::move(*visibility);
    return fallback;
}

void ScreenSpaceFallback::bind(const FrameContext& context) {
    visibility_.bind();
    context.host.bindDepth(kFallbackDepthUnit);
    visibility_.set("uDepth", kFallbackDepthUnit);
    context.frame.camera.setUniforms(visibility_, context.frame.size, context.frame.clip);
    const float thickness = context.options.layeredIntervals.thickness;
    visibility_.set("uThickness",
                    thickness > 0.0F ? thickness : kFallbackThickness * context.options.radius);
    visibility_.set("uRadius", context.options.radius);
    visibility_.set("uFalloff", static_cast<int>(context.options.falloff));
    visibility_.set("uSides", kSides);
    visibility_.set("uSteps", kSteps);
}

void ScreenSpaceFallback::fillTexture(const FrameContext& context,
                                      const gl::RenderToTexture2D& visibility) {
    const gl::Functions& gl = context.gl;
    const gl::DebugGroup group(gl, "aolib: shade what no cube map knows");
    bind(context);
    visibility_.set("uMask", kFallbackDepthUnit); // not read
    visibility_.set("uUseMask", 0);
    visibility.bindAsTarget(0);
    gl.Enable(GL_DEPTH_TEST); // covered pixels fail it: a software rasteriser, too, skips them
    context.emptyVertexArray.drawFullscreen();
    gl.Disable(GL_DEPTH_TEST);
}

void ScreenSpaceFallback::fill(const FrameContext& context, const gl::RenderToTexture2D& projected,
                               const gl::RenderToTexture2D& visibility) {
    const gl::DebugGroup group(context.gl, "aolib: shade what no cube map knows");
    bind(context);
    projected.bindTexture(0, kMaskUnit);
    visibility_.set("uMask", kMaskUnit);
    visibility_.set("uUseMask", 1);
    visibility.bindAsTarget(0);
    context.gl.ColorMaski(0, GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
    context.emptyVertexArray.drawFullscreen();
    context.gl.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace aolib
