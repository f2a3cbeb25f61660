#pragma once

#include <memory>
#include <vector>

#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/PixelSources.h"
#include "backbone/cubemapped/RasterTexels.h"
#include "backbone/cubemapped/RayTracedTexels.h"

namespace aolib {

/// What computes the cube maps of frames, and when: all of one in the call that needs it, or as
/// much in a frame as the budget allows.
class BuildSchedule {
public:
    /// All outlive it.
    BuildSchedule(const BackboneContext& context, const SceneGeometry& geometry, FaceStore& store,
                  BlockStore& blocks)
        : context_(context), geometry_(geometry), store_(store), blocks_(blocks),
          pixelSources_(context, geometry) {}

    /// Makes the sources that the options' estimator takes its texels and pixels from.
    /// Errors: ShaderError, OutOfMemory, MissingCapability.
    AoStatus chooseSource();
    /// The scene is another.
    /// @param changes  marked in the cube maps by whatever computes them.
    /// @param reach    of occluders, world units; may be infinite
    void sceneChanged(const std::vector<std::unique_ptr<CubeMapProjector>>& projectors,
                      const std::vector<Scene::Change>& changes, float reach);
    /// The tracer is about to be exchanged.
    void dropTracer();
    /// What kind of source computes the pixels of views at rest.
    PixelSources::Kind pixels() const { return pixelSources_.kind(); }
    /// One of them. @param slot  of the view.
    std::unique_ptr<AbstractPixelSource> makePixels(unsigned slot) {
        return pixelSources_.make(tracerQueue_.get(), raster_ ? &raster_->shading() : nullptr,
                                  slot);
    }
    /// Drops what is held for a cube map on its way.
    void forget(CubeMapId id);
    bool atOnce() const { return context_.options.frameBudget <= 0.0F; }
    /// Computes what cube maps lack, the first ones first: all of it, or as much as the budget
    /// allows. Lets those that are complete come in over a few frames.
    /// Errors: as chooseSource(), and those of the source.
    AoStatus compute(const std::vector<CubeMapProjector*>& projectors);
    /// Goes on with cube maps, whole, whatever the frame budget, for about as long. Complete ones
    /// need not come in. @return whether all are complete
    Result<bool> completeSome(const std::vector<CubeMapProjector*>& projectors,
                              double milliseconds);
    /// Whether nothing is left to do for a cube map, as far as one view has asked for it.
    bool finished(const CubeMapProjector& projector, const AskedTiles& asked) const;
    /// Passes that a tile needs.
    int passes() const { return passes_; }
    void beginFrame() { begun_ = 0; }
    /// Cube maps that were begun, or begun again, since beginFrame().
    int begun() const { return begun_; }
    /// GPU memory of what is on its way.
    std::size_t bytes() const { return raster_ ? raster_->bytes() : 0; }

private:
    AoStatus chooseTexels();
    AoStatus choosePixels();
    void askTracer();
    void begin(CubeMapProjector& projector);
    /// Computes all of a cube map.
    AoStatus complete(CubeMapProjector& projector);
    AoStatus advance(const std::vector<CubeMapProjector*>& projectors, double milliseconds);
    void bringIn(CubeMapProjector& projector) const;

    const BackboneContext context_;
    const SceneGeometry& geometry_;
    FaceStore& store_;
    BlockStore& blocks_;
    std::unique_ptr<RasterTexels> raster_;
    std::unique_ptr<TracerQueue> tracerQueue_;
    std::unique_ptr<RayTracedTexels> traced_;
    AbstractTexelSource* source_ = nullptr; ///< the one in use
    PixelSources pixelSources_;
    int passes_ = 1;
    int begun_ = 0;
};

} // namespace aolib
