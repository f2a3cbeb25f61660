#include "backbone/Composite.h"

#include <glm/common.hpp>

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

void beginHostColours(const BackboneContext& context, const Frame& frame) {
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

void blendIntoHost(const BackboneContext& context) {
    const gl::Functions& gl = context.gl;
    gl::beginBlending(gl, GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    context.generated.drawFullscreen();
    gl::endBlending(gl);
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

void Composite::apply(const BackboneContext& context, const Frame& frame, const Inputs& inputs) {
    const gl::DebugGroup group(context.gl, "aolib: composite");
    beginHostColours(context, frame);
    if (context.options.debugView == DebugView::Off) {
        blend(context, frame, inputs);
    } else {
        show(context, frame, inputs);
    }
    endHostColours(context);
}

void Composite::blend(const BackboneContext& context, const Frame& frame, const Inputs& inputs) {
    blend_.bind();
    inputs.visibility.bindTexture(0, 0);
    blend_.set("uVisibility", 0);
    blend_.set("uOrigin", frame.origin);
    blend_.set("uContrast", context.options.contrast);
    blendIntoHost(context);
}

void Composite::show(const BackboneContext& context, const Frame& frame, const Inputs& inputs) {
    show_.bind();
    inputs.geometry.bind(show_, frame, 0, 1);
    inputs.visibility.bindTexture(0, 2);
    inputs.projected.bindTexture(0, 3);
    show_.set("uVisibility", 2);
    show_.set("uProjected", 3);
    show_.set("uOrigin", frame.origin);
    show_.set("uView", static_cast<int>(context.options.debugView));
    show_.set("uRadius", inputs.radius);
    show_.set("uSceneSize", context.scene.bounds().diagonal());
    show_.set("uEye", glm::vec3(glm::mod(frame.camera.eye(), double{inputs.radius})));
    context.generated.drawFullscreen();
}

} // namespace aolib
