#pragma once

#include "backbone/cubemaps/CubeMapProjector.h"

namespace aolib {

/// Queries the GPU whether a cube map sees anything of a region: whether the region's box lies
/// before the distances that the cube map keeps.
class BoxVisibilityQuery {
public:
    /// Errors: ShaderError.
    static Result<BoxVisibilityQuery> create(const BackboneContext& context);

    /// Waits for the answer. May say yes when it is no, never the other way.
    bool isVisible(const BackboneContext& context, const CubeMapProjector& projector,
                   const FaceStore& store, const Bounds& region);

private:
    gl::GLSLShader shader_;
};

} // namespace aolib
