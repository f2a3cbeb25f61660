#include "backbone/frame/AppliedTextures.h"

#include <algorithm>
#include <array>

#include "gl/Label.h"

namespace aolib {

namespace {

GLuint nameOf(TextureName texture) {
    return static_cast<GLuint>(texture);
}

AoStatus unusable(const char* role, TextureName texture, const std::string& why) {
    return {StatusCode::InvalidFramebuffer, "aoApply: " + std::string(role) + " texture " +
                                                std::to_string(nameOf(texture)) + " " + why};
}

GLint attachmentValue(const gl::Functions& gl, GLenum attachment, GLenum name) {
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, attachment, name, &value);
    return value;
}

/// Attaches level 0 to the framebuffer that is bound, whatever the texture's target.
AoStatus attachTo(const gl::Functions& gl, GLenum attachment, TextureName texture,
                  const char* role) {
    if (gl.IsTexture(nameOf(texture)) == GL_FALSE) {
        return unusable(role, texture, "is none of this context");
    }
    gl.FramebufferTexture(GL_FRAMEBUFFER, attachment, nameOf(texture), 0);
    if (attachmentValue(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_LAYERED) != GL_FALSE) {
        return unusable(role, texture, "has layers; a plain 2D texture is needed");
    }
    const bool depth = attachment == GL_DEPTH_ATTACHMENT;
    if (attachmentValue(gl, attachment,
                        depth ? GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE
                              : GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) == 0) {
        return unusable(role, texture, depth ? "holds no depth" : "holds no colours");
    }
    return {};
}

AoStatus complete(const gl::Functions& gl, TextureName texture, const char* role) {
    if (const GLenum state = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
        state != GL_FRAMEBUFFER_COMPLETE) {
        return unusable(role, texture,
                        "cannot be used so: wrong format, or samples that differ from the other "
                        "textures' (framebuffer status " +
                            std::to_string(state) + ")");
    }
    return {};
}

AoStatus makeFramebuffer(const gl::Functions& gl, gl::Container& framebuffer, const char* label) {
    if (!framebuffer) {
        auto made = gl::Container::create(gl, gl::Container::kFramebuffer, label);
        if (!made) {
            return made.status();
        }
        framebuffer = std::move(*made);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl::label(gl, GL_FRAMEBUFFER, framebuffer.name(), label);
    return {};
}

} // namespace

TextureName AppliedTextures::factor() const {
    return factor_ ? TextureName{factor_.textureName(0)} : TextureName{};
}

AoStatus AppliedTextures::attachDepth(const gl::Functions& gl, const HostTextures& textures) {
    if (AoStatus status = makeFramebuffer(gl, source_, "aolib/applied/depth"); !status) {
        return status;
    }
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    if (AoStatus status = attachTo(gl, GL_DEPTH_ATTACHMENT, textures.depth, "depth"); !status) {
        return status;
    }
    // Stencil of the same texture: samples are resolved together, or not at all.
    if (attachmentValue(gl, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0) {
        gl.FramebufferTexture(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, nameOf(textures.depth), 0);
    }
    return complete(gl, textures.depth, "depth");
}

AoStatus AppliedTextures::attachNormal(const gl::Functions& gl, const HostTextures& textures) {
    if (AoStatus status = attachTo(gl, GL_COLOR_ATTACHMENT0, textures.normal, "normal"); !status) {
        return status;
    }
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    if (AoStatus status = complete(gl, textures.normal, "normal"); !status) {
        return status;
    }
    const GLint type =
        attachmentValue(gl, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
    GLint samples = 0;
    gl.GetIntegerv(GL_SAMPLES, &samples);
    if (type == GL_INT || type == GL_UNSIGNED_INT || samples > 0) {
        return unusable("normal", textures.normal,
                        samples > 0 ? "has samples; resolve it first, or leave it out"
                                    : "holds integers; floats or normalised values are needed");
    }
    return {};
}

AoStatus AppliedTextures::attachColour(const gl::Functions& gl, const HostTextures& textures) {
    if (AoStatus status = makeFramebuffer(gl, target_, "aolib/applied/colour"); !status) {
        return status;
    }
    if (AoStatus status = attachTo(gl, GL_COLOR_ATTACHMENT0, textures.colour, "colour"); !status) {
        return status;
    }
    gl.DrawBuffer(GL_COLOR_ATTACHMENT0);
    return complete(gl, textures.colour, "colour");
}

AoStatus AppliedTextures::clearFactor(const gl::Functions& gl, const glm::ivec2& size) {
    if (AoStatus status = factor_.reset(gl, {.width = size.x,
                                             .height = size.y,
                                             .targets = {gl::RenderToTexture2D::Format::R8},
                                             .label = "aolib/applied/factor"});
        !status) {
        return status;
    }
    const std::array<GLfloat, 4> one{1.0F, 1.0F, 1.0F, 1.0F};
    factor_.bindAllAsTargets();
    gl.ClearBufferfv(GL_COLOR, 0, one.data());
    return {};
}

AoStatus AppliedTextures::attach(const gl::Functions& gl, const HostTextures& textures,
                                 Frame& frame) {
    if (std::min(textures.size.x, textures.size.y) < 1) {
        return {StatusCode::InvalidFramebuffer, "aoApply: the textures are said to be " +
                                                    std::to_string(textures.size.x) + " x " +
                                                    std::to_string(textures.size.y) + " pixels"};
    }
    AoStatus status = attachDepth(gl, textures);
    frame.hostNormals = textures.normal != TextureName{};
    if (status && frame.hostNormals) {
        status = attachNormal(gl, textures);
    }
    const bool coloured = textures.colour != TextureName{};
    if (status) {
        status = coloured ? attachColour(gl, textures) : clearFactor(gl, textures.size);
    }
    frame.depthFramebuffer = source_.name();
    frame.framebuffer = coloured ? target_.name() : factor_ ? factor_.framebufferName() : 0;
    frame.origin = {0, 0};
    frame.size = textures.size;
    return status;
}

void AppliedTextures::release(const gl::Functions& gl) {
    for (const gl::Container* framebuffer : {&source_, &target_}) {
        if (*framebuffer) {
            gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer->name());
            for (const GLenum attachment :
                 {GLenum{GL_COLOR_ATTACHMENT0}, GLenum{GL_DEPTH_ATTACHMENT},
                  GLenum{GL_STENCIL_ATTACHMENT}}) {
                gl.FramebufferTexture(GL_FRAMEBUFFER, attachment, 0, 0);
            }
        }
    }
}

} // namespace aolib
