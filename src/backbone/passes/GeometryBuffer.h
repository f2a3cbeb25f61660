#pragma once

#include <optional>

#include <aolib/Status.h>

#include "backbone/frame/FrameContext.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// Linear depth and world normal of every pixel that the host drew, rebuilt from its depth buffer;
/// the normals are the host's where it gives them.
class GeometryBuffer {
public:
    /// Binds both textures and sets the uniforms of shaders/frame/geometry.glsl.
    void bind(gl::GLSLShader& shader, const Frame& frame, int depthUnit, int normalUnit) const;
    std::size_t bytes() const { return target_ ? target_.bytes() : 0; }

private:
    friend class GeometryPass;
    gl::RenderToTexture2D target_;
};

/// Fills geometry buffers.
class GeometryPass {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<GeometryPass> create(const BackboneContext& context);
    /// Rebuilds a buffer from the host's depth. Errors: OutOfMemory, MissingCapability,
    /// ShaderError.
    AoStatus update(const FrameContext& context, GeometryBuffer& buffer);

private:
    gl::GLSLShader shader_;
    std::optional<gl::GLSLShader>
        withNormals_; ///< takes the host's normals; built when first needed
};

} // namespace aolib
