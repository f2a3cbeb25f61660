#include "backbone/passes/Composite.h"

#include <utility>

#include <glm/common.hpp>

#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

namespace {

constexpr int kBlendedUnit = 0; ///< of what is blended
constexpr int kBlendEdgesUnit = 1;
constexpr int kBlendDepthUnit = 2;
constexpr int kBlendTilesUnit = 3;

} // namespace

void beginHostColours(const FrameContext& context) {
    const Frame& frame = context.frame;
    const gl::Functions& gl = context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
    gl::setViewport(gl, frame.origin.x, frame.origin.y, frame.size.x, frame.size.y);
    // The host's alpha stays, and so do the other targets of a host that draws to several.
    const int targets = gl::drawBuffersInUse(gl);
    gl::useTargets(gl, targets);
    gl.ColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    for (int i = 1; i < targets; ++i) {
        gl.ColorMaski(static_cast<GLuint>(i), GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
    if (frame.srgb) {
        gl.Enable(GL_FRAMEBUFFER_SRGB);
    }
    if (frame.scissor) {
        gl::setScissorTest(gl, true);
    }
}

void beginBlend(const BackboneContext& context) {
    gl::beginBlending(context.gl, GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
}

void endBlend(const BackboneContext& context) {
    gl::endBlending(context.gl);
}

void blendIntoHost(const BackboneContext& context) {
    beginBlend(context);
    context.emptyVertexArray.drawFullscreen();
    endBlend(context);
}

void endHostColours(const BackboneContext& context) {
    const gl::Functions& gl = context.gl;
    gl::setScissorTest(gl, false);
    gl.Disable(GL_FRAMEBUFFER_SRGB);
    for (int i = 0; i < gl.guard->output().targets(); ++i) {
        gl.ColorMaski(static_cast<GLuint>(i), GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
}

Result<Composite> Composite::create(const BackboneContext& context) {
    auto blend = buildShader(context.gl, "fullscreen.vert", "frame/composite.frag");
    if (!blend) {
        return blend.status();
    }
    auto show = buildShader(context.gl, "fullscreen.vert", "frame/debug_view.frag");
    if (!show) {
        return show.status();
    }
    Composite composite;
    composite.blend_ = std::move(*blend);
    composite.show_ = std::move(*show);
    return composite;
}

AoStatus Composite::apply(const FrameContext& context, const Inputs& inputs) {
    if (context.options.debugView == DebugView::Off) {
        return blend(context, inputs.visibility);
    }
    const gl::DebugGroup group(context.gl, "aolib: debug view");
    beginHostColours(context);
    show(context, inputs);
    endHostColours(context);
    return {};
}

AoStatus Composite::buildSampled(const gl::Functions& gl) {
    if (blendInner_ && blendSamples_) {
        return {};
    }
    auto inner = buildShader(gl, "fullscreen.vert", "frame/composite.frag", {"AO_EDGES"});
    if (!inner) {
        return inner.status();
    }
    auto samples = buildShader(gl, "frame/edge_tiles.vert", "frame/blend_samples.frag");
    if (!samples) {
        return samples.status();
    }
    blendInner_ = std::move(*inner);
    blendSamples_ = std::move(*samples);
    return {};
}

AoStatus Composite::blend(const FrameContext& context, const gl::RenderToTexture2D& visibility) {
    const gl::DebugGroup group(context.gl, "aolib: composite");
    if (context.host.samples() != nullptr) {
        if (AoStatus status = buildSampled(context.gl); !status) {
            return status;
        }
    }
    const float contrast = context.options.contrast;
    beginHostColours(context);
    beginBlend(context);
    drawPixels(context, visibility, context.frame.origin, contrast);
    if (context.host.samples() != nullptr) {
        GLint samples = 0; // of the colours: aoApply may be given others
        context.gl.GetIntegerv(GL_SAMPLES, &samples);
        drawEdges(context, visibility, context.frame.origin, contrast,
                  samples == context.host.samples()->count());
    }
    endBlend(context);
    endHostColours(context);
    return {};
}

AoStatus Composite::writeMeans(const FrameContext& context,
                               const gl::RenderToTexture2D& visibility) {
    if (AoStatus status = buildSampled(context.gl); !status) {
        return status;
    }
    drawPixels(context, visibility, glm::ivec2(0), 1.0F);
    drawEdges(context, visibility, glm::ivec2(0), 1.0F, /*each=*/false);
    return {};
}

void Composite::drawPixels(const FrameContext& context, const gl::RenderToTexture2D& visibility,
                           const glm::ivec2& origin, float contrast) {
    gl::GLSLShader& shader = context.host.samples() != nullptr ? *blendInner_ : blend_;
    shader.bind();
    visibility.bindTexture(0, kBlendedUnit);
    shader.set("uVisibility", kBlendedUnit);
    if (context.host.samples() != nullptr) {
        context.host.samples()->bindEdges(kBlendEdgesUnit);
        shader.set("uEdges", kBlendEdgesUnit);
    }
    shader.set("uOrigin", origin);
    shader.set("uContrast", contrast);
    context.emptyVertexArray.drawFullscreen();
}

void Composite::drawEdges(const FrameContext& context, const gl::RenderToTexture2D& visibility,
                          const glm::ivec2& origin, float contrast, bool each) {
    const HostSamples& samples = *context.host.samples();
    gl::GLSLShader& shader = *blendSamples_;
    shader.bind();
    samples.setUniforms(shader);
    context.frame.camera.setUniforms(shader, context.frame.size, context.frame.clip);
    visibility.bindTexture(0, kBlendedUnit);
    samples.bindEdges(kBlendEdgesUnit);
    samples.bindDepth(kBlendDepthUnit);
    shader.set("uVisibility", kBlendedUnit);
    shader.set("uEdges", kBlendEdgesUnit);
    shader.set("uDepth", kBlendDepthUnit);
    shader.set("uOrigin", origin);
    shader.set("uContrast", contrast);
    const gl::MultisampleBinding binding = samples.bindSamples(context.gl);
    const auto draw = [&](int first, int end) {
        shader.set("uFirstSample", first);
        shader.set("uEndSample", end);
        samples.drawTiles(context, shader, kBlendTilesUnit);
    };
    if (!each) {
        draw(0, samples.count());
        return;
    }
    const gl::SampleMask mask(context.gl);
    for (int sample = 0; sample < samples.count(); ++sample) {
        mask.only(sample);
        draw(sample, sample + 1);
    }
}

void Composite::show(const FrameContext& context, const Inputs& inputs) {
    show_.bind();
    inputs.geometry.bind(show_, context.frame, 0, 1);
    inputs.visibility.bindTexture(0, 2);
    inputs.projected.bindTexture(0, 3);
    show_.set("uVisibility", 2);
    show_.set("uProjected", 3);
    show_.set("uOrigin", context.frame.origin);
    show_.set("uView", static_cast<int>(context.options.debugView));
    show_.set("uRadius", context.options.radius);
    show_.set("uSceneSize", context.scene.bounds().diagonal());
    show_.set("uEye",
              glm::vec3(glm::mod(context.frame.camera.eye(), double{context.options.radius})));
    context.emptyVertexArray.drawFullscreen();
}

} // namespace aolib
