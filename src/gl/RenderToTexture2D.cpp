#include "gl/RenderToTexture2D.h"

#include <algorithm>
#include <array>

#include "gl/Label.h"

namespace aolib::gl {

namespace {

constexpr int kMaxTargets = 8;

struct TexelFormat {
    GLenum internalFormat;
    GLenum format;
    GLenum type;
    std::size_t bytes;
};

TexelFormat texelFormat(RenderToTexture2D::Format format) {
    using Format = RenderToTexture2D::Format;
    switch (format) {
    case Format::R8:
        return {GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1};
    case Format::RG8:
        return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, 2};
    case Format::RGB8:
        return {GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 3};
    case Format::RGBA8:
        return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
    case Format::R16:
        return {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2};
    case Format::R16F:
        return {GL_R16F, GL_RED, GL_FLOAT, 2};
    case Format::RG16F:
        return {GL_RG16F, GL_RG, GL_FLOAT, 4};
    case Format::RGBA16F:
        return {GL_RGBA16F, GL_RGBA, GL_FLOAT, 8};
    case Format::R32F:
        return {GL_R32F, GL_RED, GL_FLOAT, 4};
    case Format::RG32F:
        return {GL_RG32F, GL_RG, GL_FLOAT, 8};
    case Format::RGB32F:
        return {GL_RGB32F, GL_RGB, GL_FLOAT, 12};
    case Format::RGBA32F:
        return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
    }
    return {};
}

TexelFormat texelFormat(RenderToTexture2D::Depth depth) {
    using Depth = RenderToTexture2D::Depth;
    switch (depth) {
    case Depth::None:
        return {};
    case Depth::Depth16:
        return {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2};
    case Depth::Depth32:
        return {GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4};
    case Depth::Depth24:
        return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4};
    case Depth::Depth32F:
        return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4};
    case Depth::Depth24Stencil8:
        return {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4};
    case Depth::Depth32FStencil8:
        return {GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 8};
    }
    return {};
}

bool hasStencil(RenderToTexture2D::Depth depth) {
    return depth == RenderToTexture2D::Depth::Depth24Stencil8 ||
           depth == RenderToTexture2D::Depth::Depth32FStencil8;
}

GLint glWrap(RenderToTexture2D::Wrap wrap) {
    return wrap == RenderToTexture2D::Wrap::Clamp ? GL_CLAMP_TO_EDGE : GL_REPEAT;
}

GLint glFilter(RenderToTexture2D::Filter filter) {
    return filter == RenderToTexture2D::Filter::Nearest ? GL_NEAREST : GL_LINEAR;
}

} // namespace

Status RenderToTexture2D::addTexture(Texture& texture, GLenum attachment, GLenum internalFormat,
                                     GLenum format, GLenum type, const std::string& label) {
    const Functions& gl = *gl_;
    texture = generate<Texture>(gl, &Functions::GenTextures);
    if (!texture) {
        return {StatusCode::OutOfMemory, label + ": GL gave no texture name"};
    }
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
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.name(), 0);
    return {};
}

Result<RenderToTexture2D> RenderToTexture2D::create(const Functions& gl, const Settings& settings) {
    if (settings.width < 1 || settings.height < 1 ||
        settings.width > gl.capabilities.maxTextureSize ||
        settings.height > gl.capabilities.maxTextureSize ||
        static_cast<int>(settings.targets.size()) >
            std::min(gl.capabilities.maxDrawBuffers, kMaxTargets)) {
        return Status(StatusCode::MissingCapability,
                      settings.label + ": " + std::to_string(settings.targets.size()) +
                          " targets of " + std::to_string(settings.width) + " x " +
                          std::to_string(settings.height) + " texels; this context allows " +
                          std::to_string(gl.capabilities.maxDrawBuffers) + " of up to " +
                          std::to_string(gl.capabilities.maxTextureSize));
    }
    RenderToTexture2D rtt;
    rtt.gl_ = &gl;
    rtt.settings_ = settings;
    rtt.framebuffer_ = generate<Framebuffer>(gl, &Functions::GenFramebuffers);
    if (!rtt.framebuffer_) {
        return Status(StatusCode::OutOfMemory, settings.label + ": GL gave no framebuffer name");
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, rtt.framebuffer_.name());
    gl::label(gl, GL_FRAMEBUFFER, rtt.framebuffer_.name(), settings.label);
    for (std::size_t i = 0; i < settings.targets.size(); ++i) {
        const TexelFormat texel = texelFormat(settings.targets[i]);
        if (Status status =
                rtt.addTexture(rtt.textures_.emplace_back(),
                               GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), texel.internalFormat,
                               texel.format, texel.type, settings.label + "/" + std::to_string(i));
            !status) {
            return status;
        }
    }
    if (settings.depth != Depth::None) {
        const TexelFormat texel = texelFormat(settings.depth);
        const GLenum attachment =
            hasStencil(settings.depth) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
        if (Status status = rtt.addTexture(rtt.depth_, attachment, texel.internalFormat,
                                           texel.format, texel.type, settings.label + "/depth");
            !status) {
            return status;
        }
    }
    rtt.beginAll();
    if (settings.targets.empty()) {
        gl.ReadBuffer(GL_NONE);
    }
    if (const GLenum state = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
        state != GL_FRAMEBUFFER_COMPLETE) {
        return Status(StatusCode::MissingCapability,
                      settings.label +
                          ": this driver cannot render to these formats (framebuffer "
                          "status " +
                          std::to_string(state) + ")");
    }
    return rtt;
}

void RenderToTexture2D::begin(int target) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->DrawBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
    gl_->Viewport(0, 0, settings_.width, settings_.height);
}

void RenderToTexture2D::beginAll() const {
    std::array<GLenum, kMaxTargets> buffers{};
    const std::size_t count = textures_.size();
    for (std::size_t i = 0; i < count; ++i) {
        buffers[i] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    }
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->DrawBuffers(static_cast<GLsizei>(count), buffers.data());
    gl_->Viewport(0, 0, settings_.width, settings_.height);
}

void RenderToTexture2D::beginRead(int target) const {
    gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
    gl_->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(target));
}

void RenderToTexture2D::bindTextureName(GLuint name, int unit) const {
    gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->BindTexture(GL_TEXTURE_2D, name);
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
