#include "host/HostFramebuffer.h"

#include <string>
#include <utility>

namespace aolib::host {

namespace {

std::string describe(const HostFramebuffer::Settings& settings) {
    std::string text = std::to_string(settings.width) + " x " + std::to_string(settings.height);
    if (settings.samples > 0) {
        text += " with " + std::to_string(settings.samples) + " samples";
    }
    return text;
}

AoStatus checkSettings(const gl::Functions& gl, const HostFramebuffer::Settings& settings) {
    GLint maxSize = 0;
    GLint maxSamples = 0;
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &maxSize);
    gl.GetIntegerv(GL_MAX_SAMPLES, &maxSamples);
    if (settings.width < 1 || settings.height < 1 || settings.width > maxSize ||
        settings.height > maxSize || settings.samples < 0 || settings.samples > maxSamples) {
        return {StatusCode::MissingCapability, "a framebuffer of " + describe(settings) +
                                                   " is beyond this context, which has " +
                                                   std::to_string(maxSize) + " pixels and " +
                                                   std::to_string(maxSamples) + " samples at most"};
    }
    return {};
}

} // namespace

Result<HostFramebuffer> HostFramebuffer::create(const gl::Functions& gl, const Settings& settings) {
    if (AoStatus status = checkSettings(gl, settings); !status) {
        return status;
    }
    HostFramebuffer target;
    target.gl_ = &gl;
    target.settings_ = settings;
    target.framebuffer_ = gl::generate<gl::Framebuffer>(gl, &gl::Functions::GenFramebuffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_.name());
    if (AoStatus status = target.attach(target.colour_, GL_RGBA8, GL_COLOR_ATTACHMENT0); !status) {
        return status;
    }
    if (AoStatus status =
            target.attach(target.depth_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
        !status) {
        return status;
    }
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return AoStatus(StatusCode::OutOfMemory,
                        "GL gave no complete framebuffer of " + describe(settings));
    }
    return target;
}

AoStatus HostFramebuffer::attach(Renderbuffer& buffer, GLenum format, GLenum attachment) const {
    GLuint name = 0;
    gl_->GenRenderbuffers(1, &name);
    if (name == 0) {
        return {StatusCode::OutOfMemory, "GL gave no renderbuffer name"};
    }
    buffer = Renderbuffer(*gl_, name);
    gl_->BindRenderbuffer(GL_RENDERBUFFER, name);
    gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, settings_.samples, format, settings_.width,
                                        settings_.height);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
    return {};
}

void HostFramebuffer::bind() const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->Viewport(0, 0, settings_.width, settings_.height);
}

Result<ByteImage> HostFramebuffer::readColour() const {
    if (settings_.samples > 0) {
        Result<HostFramebuffer> resolved =
            create(*gl_, {settings_.width, settings_.height, /*samples=*/0});
        if (!resolved) {
            return resolved.status();
        }
        gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved->framebuffer_.name());
        gl_->BlitFramebuffer(0, 0, settings_.width, settings_.height, 0, 0, settings_.width,
                             settings_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        return resolved->readColour();
    }
    bind();
    gl_->ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    ByteImage picture(settings_.width, settings_.height, 3);
    gl_->ReadPixels(0, 0, settings_.width, settings_.height, GL_RGB, GL_UNSIGNED_BYTE,
                    picture.pixels.data());
    return picture;
}

std::vector<float> HostFramebuffer::readDepth() const {
    bind();
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
    std::vector<float> depths(static_cast<std::size_t>(settings_.width) *
                              static_cast<std::size_t>(settings_.height));
    gl_->ReadPixels(0, 0, settings_.width, settings_.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                    depths.data());
    return depths;
}

} // namespace aolib::host
