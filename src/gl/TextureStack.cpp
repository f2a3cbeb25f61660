#include "gl/TextureStack.h"

#include "gl/Label.h"
#include "gl/StateGuard.h"
#include "gl/TexelFormat.h"

namespace aolib::gl {

Result<TextureStack> TextureStack::create(const Functions& gl, const Settings& settings) {
    const int limit = gl.capabilities.maxTextureSize;
    if (settings.width < 1 || settings.height < 1 || settings.layers < 1 ||
        settings.width > limit || settings.height > limit ||
        settings.layers > gl.capabilities.maxTextureLayers) {
        return AoStatus(StatusCode::MissingCapability,
                        settings.label + ": " + std::to_string(settings.layers) + " layers of " +
                            std::to_string(settings.width) + " x " +
                            std::to_string(settings.height) + " texels; this context allows " +
                            std::to_string(gl.capabilities.maxTextureLayers) + " of up to " +
                            std::to_string(limit));
    }
    TextureStack stack;
    stack.gl_ = &gl;
    stack.settings_ = settings;
    stack.texture_ = generate<Texture>(gl, &Functions::GenTextures);
    if (!stack.texture_) {
        return AoStatus(StatusCode::OutOfMemory, settings.label + ": GL gave no texture name");
    }
    auto framebuffer = Container::create(gl, Container::kFramebuffer, settings.label);
    if (!framebuffer) {
        return framebuffer.status();
    }
    stack.framebuffer_ = std::move(*framebuffer);
    const TexelFormat texel = texelFormat(settings.format);
    usePixels(gl);
    stack.bind(0);
    gl::label(gl, GL_TEXTURE, stack.texture_.name(), settings.label);
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(texel.internalFormat), settings.width,
                  settings.height, settings.layers, 0, texel.format, texel.type, nullptr);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    GLint width = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &width);
    if (width != settings.width) {
        return AoStatus(StatusCode::OutOfMemory,
                        settings.label + ": no memory for " + std::to_string(settings.layers) +
                            " layers of " + std::to_string(settings.width) + " x " +
                            std::to_string(settings.height) + " texels");
    }
    stack.bindAsTarget(0);
    gl::label(gl, GL_FRAMEBUFFER, stack.framebuffer_.name(), settings.label);
    if (const GLenum state = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
        state != GL_FRAMEBUFFER_COMPLETE) {
        return AoStatus(StatusCode::MissingCapability,
                        settings.label +
                            ": this driver cannot render to layers of this format "
                            "(framebuffer status " +
                            std::to_string(state) + ")");
    }
    return stack;
}

void TextureStack::bindAsTarget(int layer) const {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    gl_->FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_.name(), 0, layer);
    gl_->DrawBuffer(GL_COLOR_ATTACHMENT0);
    setViewport(*gl_, 0, 0, settings_.width, settings_.height);
}

void TextureStack::attach(int location, int layer) const {
    gl_->FramebufferTextureLayer(GL_FRAMEBUFFER,
                                 GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(location),
                                 texture_.name(), 0, layer);
}

void TextureStack::upload(int layer, const glm::ivec2& at, const glm::ivec2& size,
                          const void* data) const {
    const TexelFormat texel = texelFormat(settings_.format);
    usePixels(*gl_);
    bind(0);
    gl_->TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, at.x, at.y, layer, size.x, size.y, 1, texel.format,
                       texel.type, data);
}

void TextureStack::copyFrom(const TextureStack& other) const {
    for (int layer = 0; layer < other.layers(); ++layer) {
        other.bindAsTarget(layer);
        gl_->ReadBuffer(GL_COLOR_ATTACHMENT0);
        bind(0);
        gl_->CopyTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, 0, 0, settings_.width,
                               settings_.height);
    }
}

void TextureStack::bind(int unit) const {
    gl::bindTexture(*gl_, unit, GL_TEXTURE_2D_ARRAY, texture_.name());
}

std::size_t TextureStack::bytes() const {
    return RenderToTexture2D::bytesPerTexel(settings_.format) *
           static_cast<std::size_t>(settings_.width) * static_cast<std::size_t>(settings_.height) *
           static_cast<std::size_t>(settings_.layers);
}

} // namespace aolib::gl
