#pragma once

#include <cstddef>

#include <aolib/Status.h>

#include "backbone/passes/GeometryBuffer.h"

namespace aolib {

/// What a view keeps of its blur, each of the frame's size.
struct BlurredPictures {
    gl::RenderToTexture2D rows;       ///< sums of rows
    gl::RenderToTexture2D visibility; ///< W (-1 background), and 1 shaded, 0.5 filled, 0 unshaded

    std::size_t bytes() const {
        return (rows ? rows.bytes() : 0) + (visibility ? visibility.bytes() : 0);
    }
};

/// Edge-aware blur of the projected visibility (thesis 4.5), along rows and then along columns;
/// also says which pixels are shaded.
class Blur {
public:
    /// Errors: ShaderError.
    static Result<Blur> create(const BackboneContext& context);
    /// Blurs a view's projected visibility into its `visibility`.
    /// @param projected  weighted sum of W, log2 of quality, face code, weight.
    /// @param size       pixels along the filter's edge; 1 copies. Errors: OutOfMemory.
    AoStatus apply(const FrameContext& context, const GeometryBuffer& geometry,
                   const gl::RenderToTexture2D& projected, int size, BlurredPictures& into);

private:
    gl::GLSLShader rows_;
    gl::GLSLShader columns_;
};

} // namespace aolib
