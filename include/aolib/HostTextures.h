#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace aolib {

/// The name of an OpenGL texture, as glGenTextures gave it; 0 is none.
enum class TextureName : std::uint32_t {};

/// What a host that renders to textures of its own hands to AmbientOcclusion::aoApply(). All are of
/// target GL_TEXTURE_2D, or those that are not sampled (depth, colour) GL_TEXTURE_2D_MULTISAMPLE;
/// level 0 counts. Since 0.1.
struct HostTextures {
    glm::ivec2 size{0};   ///< pixels of each texture, at least 1
    TextureName depth{};  ///< a depth or depth-stencil format, as the host drew it
    TextureName normal{}; ///< or none: world space in red, green and blue; floats or signed as they
                          ///< are, unsigned as n * 0.5 + 0.5. Any length; 0 takes the depth's
    TextureName colour{}; ///< or none: multiplied by the ambient occlusion
};

} // namespace aolib
