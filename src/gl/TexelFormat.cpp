#include "gl/TexelFormat.h"

namespace aolib::gl {

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
    case Format::RG16:
        return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT, 4};
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

GLenum depthAttachment(RenderToTexture2D::Depth depth) {
    return depth == RenderToTexture2D::Depth::Depth24Stencil8 ||
                   depth == RenderToTexture2D::Depth::Depth32FStencil8
               ? GL_DEPTH_STENCIL_ATTACHMENT
               : GL_DEPTH_ATTACHMENT;
}

} // namespace aolib::gl
