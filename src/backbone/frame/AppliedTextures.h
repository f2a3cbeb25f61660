#pragma once

#include <string>

#include <aolib/HostTextures.h>
#include <aolib/Status.h>

#include "backbone/frame/Frame.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// Makes framebuffers of the textures that a host hands to aoApply(), for as long as a call lasts:
/// a frame then reads and darkens them like any other host's framebuffer.
class AppliedTextures {
public:
    /// Attaches the textures, and sets the framebuffers of the frame. Without a host's colour
    /// texture, an own white texture is attached, which holds only the factor after the frame.
    /// Errors: InvalidFramebuffer, OutOfMemory, MissingCapability.
    AoStatus attach(const gl::Functions& gl, const HostTextures& textures, Frame& frame);
    /// Detaches the host's textures: none is kept alive.
    void release(const gl::Functions& gl);

    /// The texture that takes the colours' place; none before the first frame without colours.
    TextureName factor() const;
    std::size_t bytes() const { return factor_ ? factor_.bytes() : 0; }

private:
    AoStatus attachDepth(const gl::Functions& gl, const HostTextures& textures);
    AoStatus attachNormal(const gl::Functions& gl, const HostTextures& textures);
    AoStatus attachColour(const gl::Functions& gl, const HostTextures& textures);
    AoStatus clearFactor(const gl::Functions& gl, const glm::ivec2& size);

    gl::Container source_; ///< depth, and normals as colour 0
    gl::Container target_; ///< the host's colours
    gl::RenderToTexture2D factor_;
};

} // namespace aolib
