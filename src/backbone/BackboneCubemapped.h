#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/BuildSchedule.h"
#include "backbone/CubemappedView.h"
#include "backbone/cubemaps/CubeMaps.h"
#include "backbone/passes/CubeMapOutlines.h"
#include "backbone/passes/Projection.h"
#include "backbone/passes/ScreenSpaceFallback.h"
#include "backbone/texels/SceneGeometry.h"

namespace aolib {

/// The passes of a frame with cube maps.
struct CubeMapPasses {
    /// Errors: ShaderError, OutOfMemory.
    static Result<CubeMapPasses> create(const BackboneContext& context);

    Projection projection;
    ScreenSpaceFallback fallback;
    FeedbackPass feedback;
    CubeMapOutlines outlines;
};

/// Ambient occlusion computed once per cube map, kept, and projected onto every later frame: the
/// thesis's strategy. The host places cube maps (these are pinned), or coverage does; those that
/// see a change of the scene are computed again. With a frame budget they are computed over many
/// frames, and only where views show them.
class BackboneCubemapped final : public AbstractBackbone {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<std::unique_ptr<AbstractBackbone>> create(const BackboneContext& context);
    /// Views go before what they refer to.
    ~BackboneCubemapped() override { dropRefiners(); }

    void optionsChanged(const Options& before) override;
    void dropTracer() override;
    void rendererChanged() override { invalidateAll(); }
    BackboneCubemapped* cubemapped() override { return this; }

    // ---- Cube maps. Errors: as the calls of AmbientOcclusion.

    Result<CubeMapId> addCubeMap(const glm::vec3& position);
    /// Places pinned cube maps, unless some stand there already; all pinned ones will be computed.
    AoStatus beginPreparing(std::span<const glm::vec3> positions);
    /// Computes them for about as long. @return share that is computed; 1 when all are complete
    Result<float> goOnPreparing(double milliseconds);
    AoStatus removeCubeMap(CubeMapId id);
    void clear();
    std::vector<CubeMapInfo> cubeMaps();
    Result<CubeMapImage> readCubeMap(CubeMapId id);

private:
    BackboneCubemapped(const BackboneContext& context, FramePasses passes,
                       CubeMapPasses cubeMapPasses, FrameBudget budget);

    // ---- A frame, in order (BackboneCubemappedFrame.cpp)

    AoStatus drawFrame(const FrameContext& context) override;
    AoStatus computeVisibility(const FrameContext& context) override;
    CubemappedView& beginFrame(const FrameContext& context);
    /// Uploads what changed in the scene, and marks the cube maps that see it.
    AoStatus updateScene();
    /// Chooses the cube maps that the view uses.
    void chooseCubeMaps(const FrameContext& context, CubemappedView& view);
    /// Applies what the feedback pass found: coverage, usefulness, and the tiles that are needed.
    void applyFeedback(CubemappedView& view);
    /// Evicts cube maps where memory is short, and places one where coverage falls short.
    AoStatus placeCubeMap(const FrameContext& context, CubemappedView& view);
    /// Computes what is pending of the view's cube maps, within the budget.
    AoStatus computeTexels(CubemappedView& view);
    /// Computes pixels of a view at rest whose cube maps are complete.
    AoStatus refineStaticView(const FrameContext& context, CubemappedView& view);
    AoStatus drawVisibility(const FrameContext& context, CubemappedView& view);
    AoStatus issueFeedback(const FrameContext& context, CubemappedView& view);

    void addStatistics(Statistics& statistics, const ViewState* view) override;
    std::unique_ptr<ViewState> makeView() override;

    void invalidateAll();
    /// Marks all tiles as outdated; what they hold is shown until it is replaced.
    void markAllOutdated();
    void cubeMapsChanged();
    /// Restarts the refinement of all views: the estimate has changed.
    void restartViews();
    void beforeRemoval(CubeMapProjector& projector);
    /// Places a cube map, for which there must be room.
    Result<CubeMapId> place(const glm::vec3& position, bool pinned);
    /// The cube maps of a view and, after them, those of other views that are drawn.
    std::vector<CubeMapProjector*> wanted(const CubemappedView& view) const;
    /// Whether a view's cube maps are complete, as far as it requests them.
    bool complete(const CubemappedView& view) const;
    /// Share of the passes that cube maps need and have had.
    float shareComputed(const std::vector<CubeMapProjector*>& projectors) const;
    /// Position of the cube map that a view needs, world units; none where it needs none.
    std::optional<glm::vec3> positionWhereDue(const FrameContext& context,
                                              const CubemappedView& view) const;
    std::vector<CubeMapProjector*> pinned() const;
    /// Places one of prepare(). @return null where one stands already
    Result<CubeMapProjector*> placeToPrepare(const glm::vec3& position);
    ProjectedCubeMaps projected(const CubemappedView& view) const;
    CubemappedView& currentView() const { return static_cast<CubemappedView&>(view()); }
    template <typename Call>
    void forEachView(const Call& call) const {
        for (const auto& one : views_.all()) {
            call(static_cast<CubemappedView&>(*one));
        }
    }
    /// Drops what computes pixels of views at rest.
    void dropRefiners() const {
        forEachView([](CubemappedView& one) { one.refiner.dropRefiner(); });
    }
    bool needsFallback(const CubemappedView& view) const;
    /// Whether W is written to a texture before it is blended.
    bool needsTexture(const CubemappedView& view) const {
        return needsFallback(view) || view.host.samples() != nullptr;
    }
    bool blurs() const;

    CubeMapPasses cubeMapPasses_;
    SceneGeometry sceneGeometry_;
    CubeMaps cubeMaps_;
    TexelSources sources_;
    BuildSchedule schedule_;
    FrameBudget budget_;
    float builtRadius_ = 0.0F; ///< of the cube maps, world units
    float prepared_ = 0.0F;    ///< share of what is prepared
};

} // namespace aolib
