#pragma once

#include <array>
#include <vector>

#include "backbone/GeometryBuffer.h"
#include "backbone/cubemapped/CubeMapProjector.h"

namespace aolib {

/// Projects cube maps onto the host's view, one pass each, best quality first (thesis 4.4): the
/// best so far is carried to and fro between two textures.
class Projection {
public:
    /// Errors: ShaderError.
    static Result<Projection> create(const BackboneContext& context);

    /// @return the target whose texture 0 holds, per pixel, W (or the face's code for
    ///         DebugView::Faces) and log2 of its quality; `unshaded` where no cube map knows it.
    /// Errors: OutOfMemory.
    Result<const gl::RenderToTexture2D*> apply(const BackboneContext& context, const Frame& frame,
                                               const GeometryBuffer& geometry,
                                               const std::vector<CubeMapProjector*>& projectors,
                                               float unshaded);
    std::size_t bytes() const { return best_[0] ? 2 * best_[0].bytes() : 0; }

private:
    gl::GLSLShader shader_;
    std::array<gl::RenderToTexture2D, 2> best_;
};

} // namespace aolib
