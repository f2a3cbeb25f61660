#pragma once

#include <memory>
#include <vector>

#include "backbone/estimators/Estimators.h"
#include "backbone/refine/AbstractPixelRefiner.h"
#include "backbone/refine/LayeredRefiner.h"
#include "backbone/texels/AbstractTexelSource.h"
#include "backbone/texels/RasterTexels.h"
#include "backbone/texels/RayTracedTexels.h"
#include "backbone/texels/SceneGeometry.h"

namespace aolib {

/// Makes what computes texels and pixels: the source and the refiners that the row of the options'
/// estimator names (Estimators.h). All else uses their interfaces.
class TexelSources {
public:
    /// @param geometry, atlas  outlive it.
    TexelSources(const BackboneContext& context, const SceneGeometry& geometry, TexelAtlas& atlas)
        : context_(context), geometry_(geometry), atlas_(atlas) {}

    /// Makes the source that the options call for, and what its refiners share.
    /// Errors: ShaderError, OutOfMemory, MissingCapability, NoScene.
    AoStatus choose();
    /// The source in use; null before choose(), and after dropTracer().
    AbstractTexelSource* source() const { return source_; }
    /// The kind of refiner that computes pixels of views at rest.
    RefinerKind refinerKind() const { return refinerKind_; }
    /// Makes a refiner of that kind; null for none. @param slot  of the view, which none else has
    std::unique_ptr<AbstractPixelRefiner> makeRefiner(unsigned slot);

    /// Gives the tracer the scene as it is.
    void sceneChanged();
    /// Releases the tracer, which is about to be exchanged.
    void dropTracer();
    /// Drops what is held for a cube map that is computed.
    void forget(CubeMapId id);
    /// GPU memory of what is computed.
    std::size_t bytes() const { return raster_ ? raster_->bytes() : 0; }

private:
    AoStatus chooseTraced();
    AoStatus chooseRaster();
    AoStatus chooseRefiner();
    AoStatus makeShading();
    void makeTracerQueue();

    const BackboneContext context_;
    const SceneGeometry& geometry_;
    TexelAtlas& atlas_;
    std::unique_ptr<DeferredShading> shading_;
    std::unique_ptr<TracerQueue> tracerQueue_;
    std::unique_ptr<RasterTexels> raster_;
    std::unique_ptr<RayTracedTexels> traced_;
    AbstractTexelSource* source_ = nullptr;
    std::unique_ptr<gl::GLSLShader> lowConfidence_;           ///< of ray-traced refiners
    std::unique_ptr<LayeredRefiner::Shared> layeredRefiners_; ///< of layered refiners
    RefinerKind refinerKind_ = RefinerKind::None;
};

} // namespace aolib
