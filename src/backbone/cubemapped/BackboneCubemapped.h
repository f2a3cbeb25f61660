#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/AbstractTexelSource.h"
#include "backbone/cubemapped/CubeMapOutlines.h"
#include "backbone/cubemapped/Projection.h"
#include "backbone/cubemapped/RayTracedTexels.h"
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
        : AbstractBackbone(context), store_(context.gl), details_(context.gl) {}

    Status prepare(const Frame& frame) override;
    bool shadesDirectly() const override;
    void shadeDirectly(const Frame& frame) override;
    Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) override;
    bool noisy() const override;
    Status finishFrame(const Frame& frame) override;
    void addStatistics(Statistics& statistics) override;

    /// The source that the options' estimator takes its texels from. Errors: ShaderError,
    /// OutOfMemory, MissingCapability.
    Result<AbstractTexelSource*> source();
    /// Follows the scene: uploads, and marks the cube maps that see a change.
    Status followScene();
    /// Follows the options' face size.
    void followFaceSize();
    void markAllDirty();
    void cubeMapsChanged();
    /// Drops what the sources hold for a cube map.
    void forget(CubeMapId id);
    /// Places a cube map at the camera if one is due.
    Status placeWhereDue(const Frame& frame);
    /// Takes the survey's answers: coverage, and what cube maps are asked for.
    void heedSurvey(const std::vector<CubeMapProjector*>& projectors);
    /// Computes what the frame's cube maps lack: all of it, or as much as the budget allows.
    Status compute(const std::vector<CubeMapProjector*>& projectors);
    /// Traces the pixels of a view at rest that complete cube maps do not tell.
    Status repair(const Frame& frame);
    KeptTexels kept() const;
    /// Lets cube maps that are complete come in over a few frames.
    void bringIn(const std::vector<CubeMapProjector*>& projectors);
    bool atOnce() const { return context_.options.frameBudget <= 0.0F; }
    /// The cube maps to work on in a frame, nearest first.
    std::vector<CubeMapProjector*> nearest(const glm::vec3& camera) const;
    std::vector<std::unique_ptr<CubeMapProjector>>::iterator find(CubeMapId id);

    SceneGeometry sceneGeometry_;
    FaceStore store_;
    DetailStore details_;
    std::unique_ptr<AbstractTexelSource> raster_;
    std::unique_ptr<TracerQueue> tracerQueue_;
    std::unique_ptr<RayTracedTexels> traced_;
    std::optional<ViewRepair> repair_;
    int passes_ = 1; ///< of the source in use
    std::optional<Projection> projection_;
    std::optional<Survey> survey_;
    std::optional<SightTest> sight_;
    std::optional<CubeMapOutlines> outlines_;

    std::vector<std::unique_ptr<CubeMapProjector>> projectors_;
    std::uint32_t nextId_ = 1;
    float builtRadius_ = 0.0F; ///< that the cube maps which are not dirty were built with

    std::optional<Survey::Answer> latestSurvey_; ///< of the cube maps as they are
    Survey::Answer shownSurvey_{.frame = 0, .shaded = -1.0F, .points = {}, .footprints = {}};
    std::uint64_t framesSurveyed_ = 0;
    std::vector<CubeMapProjector*> projected_; ///< in the latest frame
    int builtInFrame_ = 0;
    bool texelsComplete_ = true; ///< of the cube maps in use, as far as views ask for them
    bool converged_ = true;      ///< and nothing is left to repair
};

} // namespace aolib
