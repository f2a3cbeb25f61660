#pragma once

#include <aolib/Status.h>

#include "backbone/Frame.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// A copy of the depth that the host drew, as a texture. The host keeps drawing to its own
/// framebuffer: nothing is redirected, so multisampling, sRGB and its own targets stay as they are.
class HostFramebuffer {
public:
    /// Copies the viewport's part of the depth buffer, resolving samples, and tells its precision.
    /// Errors: InvalidFramebuffer, OutOfMemory, MissingCapability.
    Status acquire(const gl::Functions& gl, Frame& frame);
    void bindDepth(int unit) const { depth_.bindDepthTexture(unit); }
    std::size_t bytes() const { return depth_ ? depth_.bytes() : 0; }

private:
    gl::RenderToTexture2D depth_;
    gl::RenderToTexture2D::Depth format_ = gl::RenderToTexture2D::Depth::None;
};

} // namespace aolib
