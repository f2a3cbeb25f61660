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
    /// Rebuilds it from the host's depth. Errors: OutOfMemory, MissingCapability.
    Status update(const BackboneContext& context, const Frame& frame, const HostFramebuffer& host);
    /// Binds both textures and sets the uniforms of shaders/frame/geometry.glsl.
    void bind(gl::GLSLShader& shader, const Frame& frame, int depthUnit, int normalUnit) const;
    std::size_t bytes() const { return target_ ? target_.bytes() : 0; }

private:
    gl::GLSLShader shader_;
    gl::RenderToTexture2D target_;
};

} // namespace aolib
