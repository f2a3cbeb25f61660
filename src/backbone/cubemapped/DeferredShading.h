#pragma once

#include <optional>

#include "backbone/cubemapped/FaceCapture.h"
#include "backbone/cubemapped/LayerPeeling.h"

namespace aolib {

/// A captured cube map on its way: what its estimator reads, and what it has found so far. Lives
/// only as long as there is something to compute.
struct CubeMapCapture {
    gl::RenderToTexture2D nearest;              ///< normal, distance; or ...
    std::optional<LayerPeeling::Layers> layers; ///< ... layers of solid intervals
    gl::RenderToTexture2D accumulated;          ///< six faces side by side: blocked weight, weight
    std::size_t bytes = 0;                      ///< GPU memory at the peak
};

/// Captures the scene's geometry on the faces of a cube map and computes the ambient occlusion of
/// its texels (thesis 4.2 and 4.3), tile by tile and pass by pass: each pass adds to what those
/// before it have found.
class DeferredShading {
public:
    /// Errors: ShaderError.
    static Result<DeferredShading> create(const BackboneContext& context);

    /// Passes until the options' estimate is complete.
    static int passes(const Options& options);

    /// Captures, and makes room for the faces that hold geometry.
    /// Errors: NoScene, MissingCapability, OutOfMemory, ShaderError.
    Result<CubeMapCapture> capture(const BackboneContext& context, const SceneGeometry& geometry,
                                   CubeMapProjector& projector, FaceStore& store);
    /// Adds passes [first, first + count) to the texels of a region.
    /// @param radius  reach of occluders, world units.
    void accumulate(const BackboneContext& context, const CubeMapCapture& capture, float radius,
                    const TileProgress::Region& region, int first, int count);
    /// Writes what has been found of a region to the store.
    void resolve(const BackboneContext& context, const CubeMapCapture& capture,
                 const CubeMapProjector& projector, const FaceStore& store,
                 const TileProgress::Region& region);

private:
    Status chooseEstimator(const BackboneContext& context);
    Status captureNearest(const BackboneContext& context, const SceneGeometry& geometry,
                          const DistanceRange& range, CubeMapProjector& projector, FaceStore& store,
                          CubeMapCapture& capture);
    Status captureLayers(const BackboneContext& context, const SceneGeometry& geometry,
                         const DistanceRange& range, CubeMapProjector& projector, FaceStore& store,
                         CubeMapCapture& capture);
    static void bind(gl::GLSLShader& shader, const CubeMapCapture& capture, int faceSize);

    gl::GLSLShader capture_;
    LayerPeeling peeling_;
    gl::GLSLShader visibility_;
    gl::GLSLShader resolve_;
    std::optional<Estimator> estimator_; ///< that `visibility_` and `resolve_` were built for
};

} // namespace aolib
