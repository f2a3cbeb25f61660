// The framebuffers of the host.
#include "HostObjects.h"

namespace aolib {

GLuint HostObjects::colourTexture(GLenum format, GLenum type) {
    GLuint name = 0;
    gl_.GenTextures(1, &name);
    ownTextures_.push_back(name);
    gl_.BindTexture(GL_TEXTURE_2D, name);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kWidth, kHeight, 0, GL_RGBA, type,
                   nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    return name;
}

GLuint HostObjects::renderbuffer(GLenum format, int samples) {
    GLuint name = 0;
    gl_.GenRenderbuffers(1, &name);
    renderbuffers.push_back(name);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kWidth, kHeight);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, 0);
    return name;
}

void HostObjects::makeFramebuffer(HostTarget target, const std::vector<GLuint>& colours,
                                  GLuint depth, bool stencil) {
    GLuint& name = framebuffers_[static_cast<std::size_t>(target)];
    gl_.GenFramebuffers(1, &name);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const auto attachment = static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + i);
        if (target == HostTarget::Multisampled) {
            gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, colours[i]);
        } else {
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, colours[i], 0);
        }
    }
    if (depth != 0) {
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER,
                                    stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                    GL_RENDERBUFFER, depth);
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void HostObjects::makeFramebuffers() {
    const auto bytes = [&](GLenum format) { return colourTexture(format, GL_UNSIGNED_BYTE); };
    const auto floats = [&](GLenum format) { return colourTexture(format, GL_FLOAT); };
    makeFramebuffer(HostTarget::Plain, {bytes(GL_RGBA8)}, renderbuffer(GL_DEPTH24_STENCIL8, 0),
                    true);
    makeFramebuffer(HostTarget::Srgb, {bytes(GL_SRGB8_ALPHA8)},
                    renderbuffer(GL_DEPTH24_STENCIL8, 0), true);
    makeFramebuffer(HostTarget::Multisampled, {renderbuffer(GL_RGBA8, 4)},
                    renderbuffer(GL_DEPTH24_STENCIL8, 4), true);
    makeFramebuffer(HostTarget::ManyColours, {bytes(GL_RGBA8), floats(GL_RGBA16F), bytes(GL_RGBA8)},
                    renderbuffer(GL_DEPTH_COMPONENT32F, 0), false);
    makeFramebuffer(HostTarget::FloatColour, {floats(GL_RGBA16F)},
                    renderbuffer(GL_DEPTH32F_STENCIL8, 0), true);
    makeFramebuffer(HostTarget::ColourOnly, {bytes(GL_RGBA8)}, 0, false);
    makeFramebuffer(HostTarget::Incomplete, {}, 0, false);
}

bool HostObjects::usable(HostTarget target) const {
    if (target == HostTarget::ColourOnly || target == HostTarget::Incomplete) {
        return false;
    }
    if (target != HostTarget::Default) {
        return true;
    }
    const auto before = static_cast<GLuint>(gl_.integer(GL_DRAW_FRAMEBUFFER_BINDING));
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    GLint depth = 0;
    const bool complete =
        gl_.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (complete) {
        gl_.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH,
                                                GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &depth);
    }
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, before);
    return complete && depth > 0;
}

} // namespace aolib
