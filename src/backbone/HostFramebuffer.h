#pragma once

#include <aolib/Status.h>

#include "backbone/Frame.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// A copy of the depth that the host drew, as a texture, and of its normals where it gives them.
/// The host keeps drawing to its own framebuffer: nothing is redirected, so multisampling, sRGB and
/// its own targets stay as they are.
class HostFramebuffer {
public:
    /// Copies the viewport's part of the depth buffer, resolving samples, and tells its precision.
    /// Errors: InvalidFramebuffer, OutOfMemory, MissingCapability.
    AoStatus acquire(const gl::Functions& gl, Frame& frame);
    void bindDepth(int unit) const { depth_.bindDepthTexture(unit); }
    void bindNormals(int unit) const { normals_.bindTexture(0, unit); }
    /// What the copied normals are multiplied by and what is added to get vectors.
    const glm::vec2& normalCode() const { return normalCode_; }
    std::size_t bytes() const {
        return (depth_ ? depth_.bytes() : 0) + (normals_ ? normals_.bytes() : 0);
    }

private:
    AoStatus copyDepth(const gl::Functions& gl, const Frame& frame,
                       gl::RenderToTexture2D::Depth format);
    AoStatus copyNormals(const gl::Functions& gl, const Frame& frame);

    gl::RenderToTexture2D depth_;
    gl::RenderToTexture2D normals_;
    glm::vec2 normalCode_{1.0F, 0.0F};
};

} // namespace aolib
