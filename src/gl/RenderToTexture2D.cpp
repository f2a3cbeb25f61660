#include "gl/RenderToTexture2D.h"

#include <algorithm>
#include <array>

#include "gl/Label.h"
#include "gl/StateGuard.h"
#include "gl/TexelFormat.h"

namespace aolib::gl {

namespace {

constexpr int kMaxTargets = 8;

GLint glWrap(RenderToTexture2D::Wrap wrap) {
    return wrap == RenderToTexture2D::Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
}

void setDrawBuffers(const Functions& gl, std::size_t count) {
    std::array<GLenum, kMaxTargets> buffers{};
    for (std::size_t i = 0; i < count; ++i) {
        buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    }
    gl.DrawBuffers(static_cast<GLsizei>(count), buffers.data());
}

GLint glFilter(RenderToTexture2D::Filter filter) {
    return filter == RenderToTexture2D::Filter::Nearest ? GL_NEAREST : GL_LINEAR;
}

} // namespace

AoStatus RenderToTexture2D::addTexture(Texture& texture, GLenum internalFormat, GLenum format,
                                       GLenum type, const std::string& label) {
    const Functions& gl = *gl_;
    texture = generate<Texture>(gl, &Functions::GenTextures);
    if (!texture) {
        return {StatusCode::OutOfMemory, label + ": GL gave no texture name"};
    }
    usePixels(gl);
    bindTextureName(texture.name(), 0);
    gl::label(gl, GL_TEXTURE, texture.name(), label);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), settings_.width,
                  settings_.height, 0, format, type, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, glWrap(settings_.wrapS));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, glWrap(settings_.wrapT));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, glFilter(settings_.minFilter));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, glFilter(settings_.magFilter));
    GLint width = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    if (width != settings_.width) {
        return {StatusCode::OutOfMemory, label + ": no memory for " +
                                             std::to_string(settings_.width) + " x " +
                                             std::to_string(settings_.height) + " texels"};
    }
    return {};
}

AoStatus RenderToTexture2D::addFramebuffer() {
    struct Attachment {
        GLenum point;
        GLuint texture;
    };
    std::vector<Attachment> attachments;
    for (const Texture& texture : textures_) {
        attachments.push_back(
            {GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()), texture.name()});
    }
    const std::size_t colours = attachments.size();
    if (depth_) {
        attachments.push_back({depthAttachment(settings_.depth), depth_.name()});
    }
    const auto fill = [attachments, colours, label = settings_.label](const Functions& gl,
                                                                      GLuint name) -> AoStatus {
        gl.BindFramebuffer(GL_FRAMEBUFFER, name);
        gl::label(gl, GL_FRAMEBUFFER, name, label);
        for (const Attachment& one : attachments) {
            gl.FramebufferTexture2D(GL_FRAMEBUFFER, one.point, GL_TEXTURE_2D, one.texture, 0);
        }
        setDrawBuffers(gl, colours);
        if (colours == 0) {
            gl.ReadBuffer(GL_NONE);
        }
        if (const GLenum state = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
            state != GL_FRAMEBUFFER_COMPLETE) {
            return {StatusCode::MissingCapability,
                    label +
                        ": this driver cannot render to these formats (framebuffer "
                        "status " +
                        std::to_string(state) + ")"};
        }
        return {};
    };
    auto made = Container::create(*gl_, Container::kFramebuffer, settings_.label, fill);
    if (made) {
        framebuffer_ = std::move(*made);
    }
    return made.status();
}

Result<RenderToTexture2D> RenderToTexture2D::create(const Functions& gl, const Settings& settings) {
    if (settings.width < 1 || settings.height < 1 ||
        settings.width > gl.capabilities.maxTextureSize ||
        settings.height > gl.capabilities.maxTextureSize ||
        static_cast<int>(settings.targets.size()) >
            std::min(gl.capabilities.maxDrawBuffers, kMaxTargets)) {
        return AoStatus(StatusCode::MissingCapability,
                        settings.label + ": " + std::to_string(settings.targets.size()) +
                            " targets of " + std::to_string(settings.width) + " x " +
                            std::to_string(settings.height) + " texels; this context allows " +
                            std::to_string(gl.capabilities.maxDrawBuffers) + " of up to " +
                            std::to_string(gl.capabilities.maxTextureSize));
    }
    RenderToTexture2D rtt;
    rtt.gl_ = &gl;
    rtt.settings_ = settings;
    for (std::size_t i = 0; i < settings.targets.size(); ++i) {
        const TexelFormat texel = texelFormat(settings.targets[i]);
        if (AoStatus status =
                rtt.addTexture(rtt.textures_.emplace_back(), texel.internalFormat, texel.format,
                               texel.type, settings.label + "/" + std::to_string(i));
            !status) {
            return status;
        }
    }
    if (settings.depth != Depth::None) {
        const TexelFormat texel = texelFormat(settings.depth);
        if (AoStatus status = rtt.addTexture(rtt.depth_, texel.internalFormat, texel.format,
                                             texel.type, settings.label + "/depth");
            !status) {
            return status;
        }
    }
    if (AoStatus status = rtt.addFramebuffer(); !status) {
        return status;
    }
    rtt.bindAllAsTargets();
    return rtt;
}

AoStatus RenderToTexture2D::reset(const Functions& gl, const Settings& settings) {
    if (*this && settings_ == settings) {
        return {};
    }
    Result<RenderToTexture2D> created = create(gl, settings);
    if (created) {
        *this = std::move(*created);
    }
    return created.status();
}

void RenderToTexture2D::bindAsTarget(int target) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->DrawBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
    setViewport(*gl_, 0, 0, settings_.width, settings_.height);
}

void RenderToTexture2D::bindAllAsTargets() const {
    useTargets(*gl_, static_cast<int>(textures_.size()));
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    setDrawBuffers(*gl_, textures_.size());
    setViewport(*gl_, 0, 0, settings_.width, settings_.height);
}

void RenderToTexture2D::bindForReading(int target) const {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
}

void RenderToTexture2D::bindTextureName(GLuint name, int unit) const {
    gl::bindTexture(*gl_, unit, GL_TEXTURE_2D, name);
}

void RenderToTexture2D::bindTexture(int target, int unit) const {
    bindTextureName(textures_[static_cast<std::size_t>(target)].name(), unit);
}

void RenderToTexture2D::bindDepthTexture(int unit) const {
    bindTextureName(depth_.name(), unit);
}

std::size_t RenderToTexture2D::bytesPerTexel(Format format) {
    return texelFormat(format).bytes;
}
std::size_t RenderToTexture2D::bytesPerTexel(Depth depth) {
    return texelFormat(depth).bytes;
}

std::size_t RenderToTexture2D::bytes() const {
    std::size_t perTexel = bytesPerTexel(settings_.depth);
    for (const Format format : settings_.targets) {
        perTexel += bytesPerTexel(format);
    }
    return perTexel * static_cast<std::size_t>(settings_.width) *
           static_cast<std::size_t>(settings_.height);
}

} // namespace aolib::gl
