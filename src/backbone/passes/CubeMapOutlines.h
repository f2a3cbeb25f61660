#pragma once

#include <vector>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/frame/FrameContext.h"

namespace aolib {

/// Draws a small wire cube where each cube map stands, behind what the host drew before it.
class CubeMapOutlines {
public:
    /// Errors: ShaderError.
    static Result<CubeMapOutlines> create(const BackboneContext& context);
    void draw(const FrameContext& context, const std::vector<CubeMapProjector*>& projectors);

private:
    gl::GLSLShader shader_;
};

} // namespace aolib
