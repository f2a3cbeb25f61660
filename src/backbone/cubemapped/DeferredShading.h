#pragma once

#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/CubeMapProjector.h"

namespace aolib {

/// Builds a cube map: captures the scene's geometry on its faces, then computes the ambient
/// occlusion of each texel (thesis 4.2 and 4.3). The capture lives only as long as the build.
class DeferredShading {
public:
    /// Errors: ShaderError.
    static Result<DeferredShading> create(const BackboneContext& context);

    /// @param radius  reach of occluders, world units.
    /// Errors: NoScene, MissingCapability, OutOfMemory, ShaderError; then the projector is as
    /// before.
    Status build(const BackboneContext& context, const SceneGeometry& geometry, float radius,
                 CubeMapProjector& projector);

    /// GPU memory of the capture while a cube map of this face size is built.
    static std::size_t captureBytes(int faceSize);

private:
    /// Nearest and farthest distance of geometry from the cube's centre.
    struct Range {
        float nearest;
        float farthest;
    };

    Status chooseEstimator(const BackboneContext& context);
    void capture(const BackboneContext& context, const SceneGeometry& geometry,
                 CubeMapProjector& projector, const gl::RenderToTexture2D& target,
                 const Range& range);
    void captureFace(const BackboneContext& context, const SceneGeometry& geometry,
                     CubeMapProjector& projector, int face);
    void computeVisibility(const BackboneContext& context, const CubeMapProjector& projector,
                           const gl::RenderToTexture2D& captured, float radius);

    gl::GLSLShader capture_;
    gl::GLSLShader visibility_;
    Estimator estimator_{}; ///< that `visibility_` was built for
};

} // namespace aolib
