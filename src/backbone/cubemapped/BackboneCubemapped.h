#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/BuildSchedule.h"
#include "backbone/cubemapped/CubeMapOutlines.h"
#include "backbone/cubemapped/CubeMaps.h"
#include "backbone/cubemapped/CubemappedView.h"
#include "backbone/cubemapped/Fallback.h"
#include "backbone/cubemapped/Projection.h"

namespace aolib {

/// Ambient occlusion computed once per cube map, kept, and projected onto every later frame: the
/// thesis's strategy. Cube maps are placed by hand or by coverage; those that see a change of the
/// scene are computed again. With a frame budget that goes on over many frames, and only for what
/// the views show.
class BackboneCubemapped final : public AbstractBackbone {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<std::unique_ptr<AbstractBackbone>> create(const BackboneContext& context);
    /// Views go before what they hold on to.
    ~BackboneCubemapped() override { dropSources(); }

    void optionsChanged(const Options& before) override;
    void dropTracer() override;
    void rendererChanged() override { markAllDirty(); }
    Result<CubeMapId> addCubeMap(const glm::vec3& position) override;
    AoStatus beginPreparing(std::span<const glm::vec3> positions) override;
    Result<float> goOnPreparing(double milliseconds) override;
    AoStatus removeCubeMap(CubeMapId id) override;
    AoStatus clear() override;
    std::vector<CubeMapInfo> cubeMaps() override;
    Result<CubeMapImage> readCubeMap(CubeMapId id) override;

private:
    explicit BackboneCubemapped(const BackboneContext& context)
        : AbstractBackbone(context),
          cubeMaps_(context, [this](CubeMapProjector& one) { cubeMapGoes(one); }),
          schedule_(context, sceneGeometry_, cubeMaps_.store(), cubeMaps_.blocks(),
                    [this] { return radius(); }) {}

    AoStatus prepare(const Frame& frame) override;
    bool shadesDirectly() const override;
    AoStatus shadeDirectly(const Frame& frame) override;
    Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) override;
    void fillIn(const Frame& frame, const gl::RenderToTexture2D& projected,
                const gl::RenderToTexture2D& visibility) override;
    bool noisy() const override;
    AoStatus finishFrame(const Frame& frame) override;
    void addStatistics(Statistics& statistics, const ViewState* view) override;
    std::unique_ptr<ViewState> makeView() override;

    /// Follows the scene: uploads, and marks the cube maps that see a change.
    AoStatus followScene();
    void markAllDirty();
    /// All is to be computed again, and shown until it is.
    void markAllOutdated();
    void cubeMapsChanged();
    /// What is asked about the scene has changed.
    void restartViews();
    /// Reach of occluders, world units; beyond every scene where there is no end to it.
    float reach();
    /// One is about to go.
    void cubeMapGoes(CubeMapProjector& projector);
    /// Places a cube map; there is room for it.
    Result<CubeMapId> place(const glm::vec3& position, bool byHand);
    /// Places a cube map at the camera if one is due.
    AoStatus placeWhereDue(const Frame& frame);
    /// Takes the survey's answers: coverage, and what cube maps are asked for.
    void heedSurvey(CubemappedView& view);
    /// Where the frame is seen from, for cube maps to stand.
    glm::vec3 standpoint(const Frame& frame) const;
    /// The cube maps of the current view and, after them, of others that are drawn.
    std::vector<CubeMapProjector*> wanted() const;
    /// Whether the view's cube maps are complete, as far as it asks for them.
    bool complete(CubemappedView& view);
    /// Computes what the view's cube maps lack, as much as the budget allows.
    AoStatus computeTexels(CubemappedView& view);
    /// Share of the passes that cube maps need and have had.
    float shareComputed(const std::vector<CubeMapProjector*>& projectors) const;
    std::vector<CubeMapProjector*> placedByHand() const;
    /// Places the one that prepare() asks for. @return null where one stands already
    Result<CubeMapProjector*> placeToPrepare(const glm::vec3& position);
    /// Computes pixels of a view at rest whose cube maps are complete.
    void repair(const Frame& frame);
    KeptTexels kept();
    CubemappedView& seen() const { return static_cast<CubemappedView&>(view()); }
    template <typename Call>
    void forEachView(const Call& call) const {
        for (const auto& one : views_.all()) {
            call(static_cast<CubemappedView&>(*one));
        }
    }
    /// Whoever computes pixels is about to go.
    void dropSources() const {
        forEachView([](CubemappedView& one) { one.repair.dropSource(); });
    }
    /// Whether what no cube map knows is shaded by what is in sight.
    bool fallsBack() const;
    /// Whether W goes into a texture before it is blended.
    bool tells() const { return fallsBack() || seen().host.samples() != nullptr; }

    SceneGeometry sceneGeometry_;
    CubeMaps cubeMaps_;
    BuildSchedule schedule_;
    std::optional<Projection> projection_;
    std::optional<Fallback> fallback_;
    std::optional<Survey> survey_;
    std::optional<CubeMapOutlines> outlines_;

    float builtRadius_ = 0.0F; ///< that the cube maps which are not dirty were built with

    float prepared_ = 0.0F;    ///< of what is prepared, so far
    std::uint64_t frames_ = 0; ///< ended, of all views
};

} // namespace aolib
