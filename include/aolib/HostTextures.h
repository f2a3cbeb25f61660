#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace aolib {

/// The name of an OpenGL texture, as glGenTextures returns it; 0 is none.
enum class TextureName : std::uint32_t {};

/// The host's render targets that AmbientOcclusion::aoApply() reads and writes. All are of
/// target GL_TEXTURE_2D, or those that are not sampled (depth, colour) GL_TEXTURE_2D_MULTISAMPLE;
/// level 0 counts. Since 0.1.
struct HostTextures {
    glm::ivec2 size{0};  ///< pixels of each texture, at least 1
    TextureName depth{}; ///< a depth or depth-stencil format, as the host drew it
    /// Normals in world space, in red, green and blue, of any length; or none.
    /// Float and signed formats hold n, unsigned formats n * 0.5 + 0.5.
    /// Where n is 0, the normal is derived from the depth.
    TextureName normal{};
    TextureName colour{}; ///< colours that are multiplied by the ambient occlusion; or none
};

} // namespace aolib
