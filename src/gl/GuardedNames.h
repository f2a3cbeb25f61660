#pragma once

#include <array>

#include "gl/Functions.h"

/// Names of the state that StateGuard takes aside by going through a list.
namespace aolib::gl {

// Compatibility-profile names, which the core header does not declare.
inline constexpr GLenum kAlphaTest = 0x0BC0;
inline constexpr GLenum kPolygonStipple = 0x0B42;
inline constexpr GLenum kLineStipple = 0x0B24;
inline constexpr GLenum kClampFragmentColor = 0x891B;
inline constexpr GLenum kPackInvert = 0x8758; // GL_PACK_INVERT_MESA
inline constexpr GLenum kMapColor = 0x0D10;
inline constexpr GLenum kMapStencil = 0x0D11;

// What is switched off, by the parts of StateTrust. Offsets of lines and points say nothing to
// polygons that are filled, but decide the last bit of where a software rasteriser puts them.
inline constexpr std::array kDepthToggles{
    GLenum{GL_DEPTH_TEST},
    GLenum{GL_STENCIL_TEST},
    GLenum{GL_DEPTH_CLAMP},
};
inline constexpr std::array kBlendToggles{
    GLenum{GL_COLOR_LOGIC_OP},
    GLenum{GL_FRAMEBUFFER_SRGB},
    GLenum{GL_DITHER},
};
inline constexpr std::array kRasterToggles{
    GLenum{GL_CULL_FACE},           GLenum{GL_POLYGON_OFFSET_FILL},
    GLenum{GL_POLYGON_OFFSET_LINE}, GLenum{GL_POLYGON_OFFSET_POINT},
    GLenum{GL_POLYGON_SMOOTH},      GLenum{GL_LINE_SMOOTH},
    GLenum{GL_SAMPLE_ALPHA_TO_ONE}, GLenum{GL_SAMPLE_ALPHA_TO_COVERAGE},
    GLenum{GL_SAMPLE_COVERAGE},     GLenum{GL_SAMPLE_MASK},
    GLenum{GL_MULTISAMPLE},         GLenum{GL_RASTERIZER_DISCARD},
    GLenum{GL_PRIMITIVE_RESTART},
};

inline constexpr std::array kPixelStore{
    GLenum{GL_PACK_SWAP_BYTES},    GLenum{GL_PACK_LSB_FIRST},    GLenum{GL_PACK_ROW_LENGTH},
    GLenum{GL_PACK_SKIP_ROWS},     GLenum{GL_PACK_SKIP_PIXELS},  GLenum{GL_PACK_ALIGNMENT},
    GLenum{GL_PACK_IMAGE_HEIGHT},  GLenum{GL_PACK_SKIP_IMAGES},  GLenum{GL_UNPACK_SWAP_BYTES},
    GLenum{GL_UNPACK_LSB_FIRST},   GLenum{GL_UNPACK_ROW_LENGTH}, GLenum{GL_UNPACK_SKIP_ROWS},
    GLenum{GL_UNPACK_SKIP_PIXELS}, GLenum{GL_UNPACK_ALIGNMENT},  GLenum{GL_UNPACK_IMAGE_HEIGHT},
    GLenum{GL_UNPACK_SKIP_IMAGES},
};

/// Scales of the compatibility profile's pixel transfer and, right after each, its bias.
inline constexpr std::array kPixelTransferScales{
    GLenum{0x0D14}, // GL_RED_SCALE
    GLenum{0x0D18}, // GL_GREEN_SCALE
    GLenum{0x0D1A}, // GL_BLUE_SCALE
    GLenum{0x0D1C}, // GL_ALPHA_SCALE
    GLenum{0x0D1E}, // GL_DEPTH_SCALE
};

} // namespace aolib::gl
