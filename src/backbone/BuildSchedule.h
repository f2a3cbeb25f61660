#pragma once

#include <memory>
#include <vector>

#include "backbone/TexelSources.h"
#include "backbone/frame/FrameBudget.h"

namespace aolib {

/// Decides which cube maps are computed in a frame, and how far: all of one in the call that needs
/// it, or as much as the budget allows.
class BuildSchedule {
public:
    /// @param sources  outlive it.
    BuildSchedule(const BackboneContext& context, TexelSources& sources)
        : context_(context), sources_(sources) {}

    /// Marks what changes of the scene alter in cube maps.
    /// @param reach  of occluders, world units; may be infinite
    void sceneChanged(const std::vector<std::unique_ptr<CubeMapProjector>>& projectors,
                      const std::vector<Scene::Change>& changes, float reach);
    bool atOnce() const { return context_.options.frameBudget <= 0.0F; }
    void beginFrame() { begun_ = 0; }
    /// Computes what is pending of cube maps, the first ones first: all of it, or as much as the
    /// budget allows. Complete ones fade in over a few frames. Errors: as TexelSources::choose(),
    /// and those of the source.
    AoStatus compute(const std::vector<CubeMapProjector*>& projectors, FrameBudget& budget);
    /// Computes cube maps, whole, whatever the frame budget, for about as long. Complete ones need
    /// not fade in. @return whether all are complete
    Result<bool> completeSome(const std::vector<CubeMapProjector*>& projectors, FrameBudget& budget,
                              double milliseconds);
    /// Whether nothing is left to do for a cube map, as far as one view requests it.
    bool finished(const CubeMapProjector& projector, const TileSet& requested) const;
    /// Passes that a tile needs.
    int passes() const { return passes_; }
    /// Cube maps that were begun, or restarted, since beginFrame().
    int begun() const { return begun_; }

private:
    AoStatus chooseSource();
    AbstractTexelSource& source() const { return *sources_.source(); }
    bool isDue(const CubeMapProjector& projector) const;
    void begin(CubeMapProjector& projector);
    /// Computes all of a cube map.
    AoStatus complete(CubeMapProjector& projector);
    AoStatus advance(const std::vector<CubeMapProjector*>& projectors, FrameBudget& budget,
                     double milliseconds);

    const BackboneContext context_;
    TexelSources& sources_;
    int passes_ = 1;
    int begun_ = 0;
};

} // namespace aolib
