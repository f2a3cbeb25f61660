#pragma once

#include <aolib/Status.h>

#include "backbone/GeometryBuffer.h"

namespace aolib {

/// Edge-aware blur of the projected visibility (thesis 4.5), along rows and then along columns;
/// also says which pixels are shaded.
class Blur {
public:
    /// Errors: ShaderError.
    static Result<Blur> create(const BackboneContext& context);
    /// Renders into `target`, of the frame's size: W (-1 background), and 1 shaded, 0.5 filled, 0
    /// unshaded.
    /// @param projected  as AbstractBackbone::computeVisibility() gave it.
    /// @param size       pixels along the filter's edge; 1 copies.
    /// @param rows       holds sums of rows meanwhile; becomes of the frame's size.
    /// Errors: OutOfMemory.
    AoStatus apply(const BackboneContext& context, const Frame& frame,
                   const GeometryBuffer& geometry, const gl::RenderToTexture2D& projected, int size,
                   gl::RenderToTexture2D& rows, const gl::RenderToTexture2D& target);

private:
    gl::GLSLShader rows_;
    gl::GLSLShader columns_;
};

} // namespace aolib
