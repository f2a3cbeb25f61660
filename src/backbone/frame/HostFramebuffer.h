#pragma once

#include <aolib/Status.h>

#include "backbone/frame/Frame.h"
#include "backbone/frame/HostSamples.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// A copy of the depth that the host drew, as a texture, and of its normals where it gives them.
/// The host keeps drawing to its own framebuffer: nothing is redirected, so multisampling, sRGB and
/// its own targets stay as they are.
class HostFramebuffer {
public:
    /// Copies the viewport's part of the depth buffer, its samples too, and sets the frame's
    /// precision. Errors: InvalidFramebuffer, OutOfMemory, MissingCapability, ShaderError.
    AoStatus acquire(const BackboneContext& context, Frame& frame);
    /// One depth per pixel.
    void bindDepth(int unit) const {
        sampled_ ? samples_.bindDepth(unit) : depth_.bindDepthTexture(unit);
    }
    /// Null where the host's depth has one sample per pixel.
    const HostSamples* samples() const { return sampled_ ? &samples_ : nullptr; }
    void bindNormals(int unit) const { normals_.bindTexture(0, unit); }
    /// Scale and offset that convert the copied normals to vectors.
    const glm::vec2& normalCode() const { return normalCode_; }
    std::size_t bytes() const {
        return (depth_ ? depth_.bytes() : 0) + (normals_ ? normals_.bytes() : 0) + samples_.bytes();
    }

private:
    AoStatus copyDepth(const BackboneContext& context, const Frame& frame,
                       gl::RenderToTexture2D::Depth format);
    /// The depth alone, of some sample where there are several.
    AoStatus copyOneSample(const gl::Functions& gl, const Frame& frame,
                           gl::RenderToTexture2D::Depth format, int samples);
    AoStatus copyNormals(const gl::Functions& gl, const Frame& frame);

    gl::RenderToTexture2D depth_; ///< of hosts without samples
    HostSamples samples_;
    bool sampled_ = false; ///< samples_ holds the frame's depth
    gl::RenderToTexture2D normals_;
    glm::vec2 normalCode_{1.0F, 0.0F};
};

} // namespace aolib
