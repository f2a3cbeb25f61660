#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/AbstractBackbone.h"
#include "backbone/SceneGeometry.h"
#include "backbone/cubemapped/Coverage.h"
#include "backbone/cubemapped/CubeMapOutlines.h"
#include "backbone/cubemapped/CubeMapProjector.h"
#include "backbone/cubemapped/DeferredShading.h"
#include "backbone/cubemapped/Projection.h"
#include "backbone/cubemapped/SightTest.h"

namespace aolib {

/// Ambient occlusion computed once per cube map, kept, and projected onto every later frame: the
/// thesis's strategy. Cube maps are placed by hand or by coverage; those that see a change of the
/// scene are built again when they are next used.
class BackboneCubemapped final : public AbstractBackbone {
public:
    /// Errors: ShaderError, OutOfMemory.
    static Result<std::unique_ptr<AbstractBackbone>> create(const BackboneContext& context);

    void optionsChanged(const Options& before) override;
    Result<CubeMapId> addCubeMap(const glm::vec3& position) override;
    Status removeCubeMap(CubeMapId id) override;
    Status clear() override;
    std::vector<CubeMapInfo> cubeMaps() override;
    Result<CubeMapImage> readCubeMap(CubeMapId id) override;

private:
    using AbstractBackbone::AbstractBackbone;

    Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) override;
    Status finishFrame(const Frame& frame) override;
    void addStatistics(Statistics& statistics) override;

    /// Follows the scene: uploads, and marks the cube maps that see a change.
    Status followScene();
    void markAllDirty();
    /// Places a cube map at the camera if one is due.
    Status placeWhereDue(const Frame& frame);
    Status build(CubeMapProjector& projector);
    /// The cube maps to project, nearest first.
    std::vector<CubeMapProjector*> nearest(const glm::vec3& camera) const;
    std::vector<std::unique_ptr<CubeMapProjector>>::iterator find(CubeMapId id);

    SceneGeometry sceneGeometry_;
    std::optional<DeferredShading> shading_;
    std::optional<Projection> projection_;
    std::optional<Coverage> coverage_;
    std::optional<SightTest> sight_;
    std::optional<CubeMapOutlines> outlines_;

    std::vector<std::unique_ptr<CubeMapProjector>> projectors_;
    std::uint32_t nextId_ = 1;
    float builtRadius_ = 0.0F; ///< that the cube maps which are not dirty were built with

    std::optional<Coverage::Answer> latestCoverage_; ///< of the cube maps as they are
    Coverage::Answer shownCoverage_{0, -1.0F};
    std::uint64_t framesCounted_ = 0;
    int projectedInFrame_ = 0;
    int builtInFrame_ = 0;
};

} // namespace aolib
