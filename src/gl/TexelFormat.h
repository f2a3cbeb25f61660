#pragma once

#include <cstddef>

#include "gl/RenderToTexture2D.h"

namespace aolib::gl {

/// What OpenGL calls a format, and its size.
struct TexelFormat {
    GLenum internalFormat;
    GLenum format;
    GLenum type;
    std::size_t bytes; ///< per texel
};

TexelFormat texelFormat(RenderToTexture2D::Format format);
/// All zero for Depth::None.
TexelFormat texelFormat(RenderToTexture2D::Depth depth);
/// Where a depth texture is attached: as depth, or as depth and stencil.
GLenum depthAttachment(RenderToTexture2D::Depth depth);

} // namespace aolib::gl
