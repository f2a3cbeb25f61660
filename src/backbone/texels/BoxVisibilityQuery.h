#pragma once

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/frame/Frame.h"

namespace aolib {

/// Queries the GPU whether a cube map sees anything of a region: whether the region's box lies
/// before the distances that the cube map keeps.
class BoxVisibilityQuery {
public:
    /// Errors: ShaderError.
    static Result<BoxVisibilityQuery> create(const BackboneContext& context);

    /// Waits for the answer. Conservative: may report a hidden box as
    /// visible, never a visible one as hidden.
    bool isVisible(const BackboneContext& context, const CubeMapProjector& projector,
                   const FaceStore& store, const Bounds& region);

private:
    gl::GLSLShader shader_;
};

} // namespace aolib
