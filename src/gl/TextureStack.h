#pragma once

#include <cstddef>
#include <string>

#include <aolib/Status.h>
#include <glm/vec2.hpp>

#include "gl/Container.h"
#include "gl/Handle.h"
#include "gl/RenderToTexture2D.h"

namespace aolib::gl {

/// Layers of one size and format in one array texture; each can be rendered to, all are read at
/// once.
class TextureStack {
public:
    struct Settings {
        int width = 0;  ///< texels
        int height = 0; ///< texels
        int layers = 0;
        RenderToTexture2D::Format format = RenderToTexture2D::Format::RGBA8;
        std::string label;
    };

    TextureStack() = default;
    /// Errors: MissingCapability (size or format), OutOfMemory.
    static Result<TextureStack> create(const Functions& gl, const Settings& settings);

    /// Directs rendering to one layer; sets the viewport.
    void bindAsTarget(int layer) const;
    /// Makes one layer a colour target of the framebuffer that is bound.
    void attach(int location, int layer) const;
    /// Replaces part of a layer; the data has the format's own channels and type, rows
    /// close-packed.
    void upload(int layer, const glm::ivec2& at, const glm::ivec2& size, const void* data) const;
    /// Copies all layers of a stack that has no more layers, and the same size and format.
    void copyFrom(const TextureStack& other) const;
    /// Makes all layers readable by samplers of this texture unit (GL_TEXTURE_2D_ARRAY).
    void bind(int unit) const;

    int layers() const { return settings_.layers; }
    std::size_t bytes() const;

private:
    const Functions* gl_ = nullptr;
    Settings settings_;
    Texture texture_;
    Container framebuffer_;
};

} // namespace aolib::gl
