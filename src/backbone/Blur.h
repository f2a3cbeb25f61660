#pragma once

#include <aolib/Status.h>

#include "backbone/GeometryBuffer.h"

namespace aolib {

/// Edge-aware blur of the projected visibility (thesis 4.5); also says which pixels are shaded.
class Blur {
public:
    /// Errors: ShaderError.
    static Result<Blur> create(const BackboneContext& context);
    /// Renders into the bound target: W (-1 background), and 1 shaded, 0.5 filled, 0 unshaded.
    /// @param projected  as AbstractBackbone::computeVisibility() gave it.
    /// @param size       pixels along the filter's edge; 1 copies.
    void apply(const BackboneContext& context, const Frame& frame, const GeometryBuffer& geometry,
               const gl::RenderToTexture2D& projected, int size);

private:
    gl::GLSLShader shader_;
};

} // namespace aolib
