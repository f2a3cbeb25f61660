#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>

#include "backbone/cubemapped/AbstractTexelSource.h"
#include "backbone/cubemapped/DeferredShading.h"
#include "backbone/cubemapped/SightTest.h"

namespace aolib {

/// Texels by rasterisation: the scene is captured on a cube map's faces, and a shader looks about
/// in the capture. The capture is given back once all that is asked for is computed. With layers,
/// the surfaces behind those that it sees are computed, too, in tiles in which some view asks for
/// them.
class RasterTexels final : public AbstractTexelSource {
public:
    /// Errors: ShaderError.
    static Result<std::unique_ptr<RasterTexels>> create(const BackboneContext& context,
                                                        const SceneGeometry& geometry,
                                                        FaceStore& store, BlockStore& blocks);

    /// What captures and computes, for whoever needs the same of other points.
    DeferredShading& shading() { return shading_; }

    int passes() const override { return DeferredShading::passes(context_.options); }
    AoStatus complete(CubeMapProjector& projector) override;
    AoStatus advance(const std::vector<CubeMapProjector*>& projectors,
                     double milliseconds) override;
    bool lacks(const CubeMapProjector& projector) const override;
    bool keeps(const CubeMapProjector& projector) const override;
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
    /// Frames for which a capture is kept after its last use: a turning camera asks for more.
    static constexpr int kIdleFrames = 30;

    struct Work {
        CubeMapCapture capture;
        std::set<int> tiles;  ///< that have had passes from this capture
        std::set<int> toKeep; ///< of these, those that are still to be written once more
        Bounds changed;       ///< what is not as it was captured, out of sight
        bool mayBreak = true; ///< it may be broken off: the one before was not
        int idleFrames = 0;
    };

    RasterTexels(const BackboneContext& context, const SceneGeometry& geometry, FaceStore& store,
                 BlockStore& blocks)
        : context_(context), geometry_(geometry), store_(store), blocks_(blocks) {}

    Result<Work*> begin(CubeMapProjector& projector);
    bool capturing(CubeMapId id) const;
    /// Goes on with a cube map while the frame has room. @return whether it has still.
    Result<bool> goOn(CubeMapProjector& projector);
    Result<bool> goOnCapturing(CubeMapProjector& projector, Work& work);
    bool goOnComputing(CubeMapProjector& projector, Work& work);
    bool goOnKeeping(CubeMapProjector& projector, Work& work);
    Result<bool> goOnBehind(CubeMapProjector& projector, Work& work);
    /// A pass of a tile's block; after the last one it is kept.
    AoStatus computeBehind(CubeMapProjector& projector, Work& work, int tile);
    /// The tile whose block is to be computed next: the one that was begun before others.
    std::optional<int> nextBehind(const CubeMapProjector& projector, const Work& work) const;
    /// One pass over each of the tiles that need it most. @return how many.
    int computeTiles(CubeMapProjector& projector, Work& work, int most);
    void keep(const CubeMapProjector& projector, const Work& work, int tile);

    const BackboneContext context_;
    const SceneGeometry& geometry_;
    FaceStore& store_;
    BlockStore& blocks_;
    DeferredShading shading_;
    SightTest sight_;
    FrameBudget budget_;
    std::map<CubeMapId, Work> works_;
    std::set<CubeMapId> brokenOff_; ///< whose last work was not ended
};

} // namespace aolib
