#pragma once

#include <aolib/Status.h>

#include "backbone/HostFramebuffer.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// Linear depth and world normal of every pixel that the host drew, rebuilt from its depth buffer.
class GeometryBuffer {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<GeometryBuffer> create(const BackboneContext& context);
    /// Reads the host's framebuffer. Errors: InvalidFramebuffer, OutOfMemory, MissingCapability.
    Status update(const BackboneContext& context, Frame& frame);
    /// Binds both textures and sets the uniforms of shaders/frame/geometry.glsl.
    void bind(gl::GLSLShader& shader, const Frame& frame, int depthUnit, int normalUnit) const;
    /// Binds the depth alone: for passes that ask only what is background.
    void bindDepth(int unit) const { target_.bindTexture(0, unit); }
    std::size_t bytes() const { return host_.bytes() + (target_ ? target_.bytes() : 0); }

private:
    HostFramebuffer host_;
    gl::GLSLShader shader_;
    gl::RenderToTexture2D target_;
};

} // namespace aolib
