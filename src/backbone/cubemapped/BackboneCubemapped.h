#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/BuildSchedule.h"
#include "backbone/cubemapped/CubeMapOutlines.h"
#include "backbone/cubemapped/Eviction.h"
#include "backbone/cubemapped/Projection.h"
#include "backbone/cubemapped/SightTest.h"
#include "backbone/cubemapped/Survey.h"
#include "backbone/cubemapped/ViewRepair.h"

namespace aolib {

/// Ambient occlusion computed once per cube map, kept, and projected onto every later frame: the
/// thesis's strategy. Cube maps are placed by hand or by coverage; those that see a change of the
/// scene are computed again. With a frame budget that goes on over many frames, and only for what
/// the views show.
class BackboneCubemapped final : public AbstractBackbone {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<std::unique_ptr<AbstractBackbone>> create(const BackboneContext& context);

    void optionsChanged(const Options& before) override;
    void dropTracer() override;
    void rendererChanged() override { markAllDirty(); }
    Result<CubeMapId> addCubeMap(const glm::vec3& position) override;
    Status removeCubeMap(CubeMapId id) override;
    Status clear() override;
    std::vector<CubeMapInfo> cubeMaps() override;
    Result<CubeMapImage> readCubeMap(CubeMapId id) override;

private:
    explicit BackboneCubemapped(const BackboneContext& context)
        : AbstractBackbone(context), store_(context.gl), details_(store_),
          schedule_(context, sceneGeometry_, store_, details_, [this] { return radius(); }) {}

    Status prepare(const Frame& frame) override;
    bool shadesDirectly() const override;
    void shadeDirectly(const Frame& frame) override;
    Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) override;
    bool noisy() const override;
    Status finishFrame(const Frame& frame) override;
    void addStatistics(Statistics& statistics) override;

    /// Follows the scene: uploads, and marks the cube maps that see a change.
    Status followScene();
    /// Follows the options' face size and memory budget.
    void followStore();
    void markAllDirty();
    void cubeMapsChanged();
    /// Places a cube map, for which room is made first.
    Result<CubeMapId> place(const glm::vec3& position, bool byHand);
    /// Places a cube map at the camera if one is due.
    Status placeWhereDue(const Frame& frame);
    /// Makes room for one thing more, within some frames: what is in view fades out before it goes.
    /// @return whether there is room now.
    bool makeRoom(Eviction::For reason, const Frame& frame);
    /// Has those go that have faded out, and makes room for detail that is in view.
    void evictWhereDue(const Frame& frame);
    void evict(const CubeMapProjector& projector);
    /// Takes the survey's answers: coverage, and what cube maps are asked for.
    void heedSurvey(const std::vector<CubeMapProjector*>& projectors);
    /// Traces the pixels of a view at rest that complete cube maps do not tell.
    Status repair(const Frame& frame);
    KeptTexels kept() const;
    /// The cube maps to work on in a frame, nearest first.
    std::vector<CubeMapProjector*> nearest(const glm::vec3& camera) const;
    std::vector<std::unique_ptr<CubeMapProjector>>::iterator find(CubeMapId id);

    SceneGeometry sceneGeometry_;
    FaceStore store_;
    DetailStore details_;
    BuildSchedule schedule_;
    std::optional<ViewRepair> repair_;
    std::optional<Projection> projection_;
    std::optional<Survey> survey_;
    std::optional<SightTest> sight_;
    std::optional<CubeMapOutlines> outlines_;

    std::vector<std::unique_ptr<CubeMapProjector>> projectors_;
    std::uint32_t nextId_ = 1;
    std::uint64_t evicted_ = 0;
    float builtRadius_ = 0.0F; ///< that the cube maps which are not dirty were built with

    std::optional<Survey::Answer> latestSurvey_; ///< of the cube maps as they are
    Survey::Answer shownSurvey_{
        .frame = 0, .shaded = -1.0F, .points = {}, .footprints = {}, .best = {}};
    std::uint64_t framesSurveyed_ = 0;
    std::vector<CubeMapProjector*> projected_; ///< in the latest frame
    bool texelsComplete_ = true; ///< of the cube maps in use, as far as views ask for them
    bool converged_ = true;      ///< and nothing is left to repair
};

} // namespace aolib
