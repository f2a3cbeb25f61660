#pragma once

#include "backbone/cubemapped/FaceCapture.h"
#include "backbone/cubemapped/LayerPeeling.h"

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

private:
    Status chooseEstimator(const BackboneContext& context);
    Status shadeNearest(const BackboneContext& context, const SceneGeometry& geometry, float radius,
                        const DistanceRange& range, CubeMapProjector& projector);
    Status shadeLayers(const BackboneContext& context, const SceneGeometry& geometry, float radius,
                       const DistanceRange& range, CubeMapProjector& projector);
    /// Runs the bound shader over the faces that hold geometry.
    void shadeFaces(const BackboneContext& context, gl::GLSLShader& shader,
                    const CubeMapProjector& projector, const gl::RenderToTexture2D& texels);

    gl::GLSLShader capture_;
    LayerPeeling peeling_;
    gl::GLSLShader visibility_;
    gl::GLSLShader smooth_;
    Estimator estimator_{}; ///< that `visibility_` was built for
};

} // namespace aolib
