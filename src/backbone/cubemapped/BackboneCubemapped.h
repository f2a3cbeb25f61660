#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/BuildSchedule.h"
#include "backbone/cubemapped/CubeMapOutlines.h"
#include "backbone/cubemapped/CubeMaps.h"
#include "backbone/cubemapped/Fallback.h"
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
    void addStatistics(Statistics& statistics) override;

    /// Follows the scene: uploads, and marks the cube maps that see a change.
    AoStatus followScene();
    void markAllDirty();
    void cubeMapsChanged();
    /// One is about to go.
    void cubeMapGoes(CubeMapProjector& projector);
    /// Places a cube map; there is room for it.
    Result<CubeMapId> place(const glm::vec3& position, bool byHand);
    /// Places a cube map at the camera if one is due.
    AoStatus placeWhereDue(const Frame& frame);
    /// The latest survey saw this view, as it is now that nothing is left to compute.
    bool nothingToSurvey() const;
    /// From one survey to the next.
    std::uint64_t framesToSurvey() const;
    /// Takes the survey's answers: coverage, and what cube maps are asked for.
    void heedSurvey(const std::vector<CubeMapProjector*>& projectors);
    /// Computes pixels of a view at rest whose cube maps are complete.
    void repair(const Frame& frame);
    KeptTexels kept() const;
    /// Whether what no cube map knows is shaded by what is in sight.
    bool fallsBack() const;
    /// Whether W goes into a texture before it is blended.
    bool tells() const { return fallsBack() || host_.samples() != nullptr; }

    SceneGeometry sceneGeometry_;
    CubeMaps cubeMaps_;
    BuildSchedule schedule_;
    ViewRepair repair_;
    AoStatus repairStatus_; ///< of the latest frame
    std::optional<Projection> projection_;
    std::optional<Fallback> fallback_;
    std::optional<Survey> survey_;
    std::optional<SightTest> sight_;
    std::optional<CubeMapOutlines> outlines_;

    float builtRadius_ = 0.0F; ///< that the cube maps which are not dirty were built with

    std::optional<Survey::Answer> latestSurvey_; ///< of the cube maps as they are
    Survey::Answer shownSurvey_{.frame = 0,
                                .shaded = -1.0F,
                                .points = {},
                                .shades = {},
                                .footprints = {},
                                .hiddenFrom = {},
                                .best = {},
                                .projected = {}};
    /// Share of the surfaces that are shaded, or may be by what is on its way.
    std::optional<float> coverageToCome_;
    std::uint64_t frames_ = 0;                 ///< ended
    std::vector<CubeMapProjector*> projected_; ///< in the latest frame
    bool texelsComplete_ = true;    ///< of the cube maps in use, as far as views ask for them
    bool converged_ = true;         ///< and nothing is left to repair
    std::uint64_t convergedIn_ = 0; ///< the frame in which that came true
};

} // namespace aolib
