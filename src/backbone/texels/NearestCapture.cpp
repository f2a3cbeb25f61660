#include "backbone/texels/NearestCapture.h"

#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

AoStatus NearestCapture::makeTarget() {
    auto target = gl::RenderToTexture2D::create(
        context_.gl, {.width = kFaces * faces_.size(),
                      .height = faces_.size(),
                      .targets = {gl::RenderToTexture2D::Format::RGBA32F},
                      .depth = gl::RenderToTexture2D::Depth::Depth32F,
                      .label = "aolib/capture"});
    if (!target) {
        return target.status();
    }
    target_ = std::move(*target);
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, -1.0F};
    const GLfloat deepest = 1.0F;
    target_.bindAllAsTargets();
    context_.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    context_.gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    return {};
}

AoStatus NearestCapture::step() {
    const gl::DebugGroup group(context_.gl, "aolib: capture a face");
    if (!target_) {
        return makeTarget();
    }
    target_.bindAllAsTargets();
    gl::setViewport(context_.gl, face_ * faces_.size(), 0, faces_.size(), faces_.size());
    shader_.bind();
    modelled_[static_cast<std::size_t>(face_)] = faces_.draw(shader_, face_);
    ++face_;
    return {};
}

void NearestCapture::bind(gl::GLSLShader& shader) const {
    target_.bindTexture(0, 0);
    shader.set("uGeometry", 0);
    shader.set("uFaceSize", faces_.size());
}

} // namespace aolib
