#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include "backbone/texels/AbstractTexelSource.h"
#include "backbone/texels/BoxVisibilityQuery.h"
#include "backbone/texels/DeferredShading.h"

namespace aolib {

/// Computes texels by rasterisation: the scene is captured on a cube map's faces, and a shader
/// samples the capture around each texel. The capture is released when all requests are computed.
/// With layers, hidden surfaces are also computed, in tiles for which a view requests them.
class RasterTexels final : public AbstractTexelSource {
public:
    /// @param geometry, atlas, shading  outlive it. Errors: ShaderError.
    static Result<std::unique_ptr<RasterTexels>> create(const BackboneContext& context,
                                                        const SceneGeometry& geometry,
                                                        TexelAtlas& atlas,
                                                        DeferredShading& shading);

    int passes() const override;
    void beginFrame(const std::vector<CubeMapProjector*>& projectors) override;
    std::optional<WorkUnit> next() override;
    bool isReady() override;
    Result<int> step(int most) override;
    AoStatus complete(CubeMapProjector& projector) override;
    bool hasPending(const CubeMapProjector& projector) const override;
    bool areFinal(const CubeMapProjector& projector) const override;
    void sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                      float reach) override;
    bool mayRestart(const CubeMapProjector& projector) const override;
    void restart(CubeMapProjector& projector) override;
    void forget(CubeMapId id) override {
        works_.erase(id);
        brokenOff_.erase(id);
    }
    std::size_t bytes() const override;

private:
    /// Frames for which a capture is kept after its last use: a turning camera requests more.
    static constexpr int kIdleFrames = 30;
    /// Frames without a change after which work on an older scene is always cancelled.
    static constexpr int kRestFrames = 8;

    struct Work {
        CubeMapCapture capture;
        std::set<int> tiles;  ///< that have had passes from this capture
        std::set<int> toKeep; ///< of these, those that are still to be written once more
        Bounds changed; ///< region that has changed since the capture, hidden from the cube map
        bool mayBreak = true; ///< the capture may be cancelled: the one before was not
        int idleFrames = 0;
    };

    RasterTexels(const BackboneContext& context, const SceneGeometry& geometry, TexelAtlas& atlas,
                 DeferredShading& shading, BoxVisibilityQuery boxVisibility)
        : context_(context), geometry_(geometry), atlas_(atlas), shading_(shading),
          boxVisibility_(std::move(boxVisibility)) {}

    /// The first cube map of the frame for which something is pending; null where none is.
    CubeMapProjector* current() const;
    Work* find(CubeMapId id);
    const Work* find(CubeMapId id) const;
    Result<Work*> begin(CubeMapProjector& projector);
    bool isCapturing(CubeMapId id) const;
    /// Does units of the kind that a cube map needs next. @return how many
    Result<int> step(CubeMapProjector& projector, Work& work, int most);
    /// Computes one pass over each of the tiles that need it most. @return how many
    int computeTiles(CubeMapProjector& projector, Work& work, int most);
    int keepTiles(const CubeMapProjector& projector, Work& work, int most);
    Result<int> computeHiddenTiles(CubeMapProjector& projector, Work& work, int most);
    /// Computes a pass of a tile's page; after the last one the page is written.
    AoStatus computeHiddenTile(CubeMapProjector& projector, Work& work, int tile);
    /// The tile whose page is computed next: the one that was begun before others.
    std::optional<int> nextHiddenTile(const CubeMapProjector& projector, const Work& work) const;
    void keep(const CubeMapProjector& projector, const Work& work, int tile);

    const BackboneContext context_;
    const SceneGeometry& geometry_;
    TexelAtlas& atlas_;
    DeferredShading& shading_;
    BoxVisibilityQuery boxVisibility_;
    std::vector<CubeMapProjector*> projectors_; ///< of the frame
    std::map<CubeMapId, Work> works_;
    std::set<CubeMapId> brokenOff_; ///< cube maps whose last work was cancelled
    int framesAtRest_ = 0;          ///< since a change of the scene altered a tile
};

} // namespace aolib
