#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "backbone/frame/Frame.h"
#include "backbone/texels/AbstractTexelSource.h"
#include "backbone/texels/TexelCodes.h"
#include "backbone/texels/TileTurns.h"
#include "backbone/texels/TracerQueue.h"

namespace aolib {

/// Computes texels by ray tracing: a tracer computes tiles in the background, and their results are
/// uploaded to the GPU. Each pass continues the ray sequences of a tile.
///
/// When the scene changes, only tiles that the change may alter are restarted. Each result has the
/// number of its scene. A result of an older scene is shown until a newer one arrives, but is not
/// accumulated. A tile that changes in every frame thus shows its latest result, and other tiles
/// continue.
class RayTracedTexels final : public AbstractTexelSource {
public:
    /// @param atlas, queue  outlive it.
    RayTracedTexels(const BackboneContext& context, TexelAtlas& atlas, TracerQueue& queue)
        : context_(context), atlas_(atlas), queue_(queue) {}

    int passes() const override;
    void beginFrame(const std::vector<CubeMapProjector*>& projectors) override {
        projectors_ = projectors;
    }
    AoStatus endFrame() override;
    std::optional<WorkUnit> next() override;
    Result<int> step(int most) override;
    void await(double milliseconds) override { queue_.wait(milliseconds); }
    AoStatus complete(CubeMapProjector& projector) override;
    bool hasPending(const CubeMapProjector& projector) const override;
    void sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                      float reach) override;
    void restart(CubeMapProjector& projector) override;
    void forget(CubeMapId id) override { works_.erase(id); }

private:
    /// What has been traced of a tile, until it is complete.
    struct Tile {
        std::vector<float> sum; ///< per texel: W times rays
        int rays = 0;
    };
    /// What a tile shows, and since when that is out of date. Scenes by their numbers.
    struct Shown {
        std::uint64_t scene = 0;     ///< the traced scene
        std::uint64_t changedIn = 0; ///< results of scenes before are out of date
        SeenSurfaces seen;           ///< everything, until a result arrives
    };
    struct Work {
        std::map<int, Tile> tiles;
        std::map<int, Tile> pages;
        std::vector<Shown> shown; ///< by tile
        bool spans = false;       ///< the projector's code spans the scene as it is
    };
    /// A tile, or its page, with a pending pass.
    struct Wanted {
        CubeMapProjector* projector;
        int tile;
        bool detail;
        int passes; ///< that it has had
    };
    /// Tiles without a pass that counts, and tiles that have one: to be refined.
    struct Lists {
        std::vector<Wanted> first;
        std::vector<Wanted> refined;
    };

    Work& workOf(const CubeMapProjector& projector);
    const Shown& shown(const CubeMapProjector& projector, int tile);
    /// Requests the next pass of every tile that is not complete, those with the fewest passes
    /// first.
    void request();
    Lists lists();
    TexelRequest requestFor(const Wanted& wanted) const;
    /// Whether a result is of this cube map, and of the options as they are but for the scene.
    bool fits(const CubeMapProjector& projector, const TracedTexels& traced, bool detail) const;
    /// Whether a result belongs to the scene and the radius as they are for a tile.
    bool counts(const CubeMapProjector& projector, const TracedTexels& traced, int tile);
    AoStatus take(const TracedTexels& traced);
    AoStatus takeFace(CubeMapProjector& projector, const TracedTexels& traced, int tile);
    /// Shows a result that is out of date, where it is newer than what is shown.
    AoStatus takeOutdated(CubeMapProjector& projector, const TracedTexels& traced, int tile);
    AoStatus takePage(CubeMapProjector& projector, const TracedTexels& traced, int tile);
    /// Adds a pass. @return false when it has been traced before.
    static bool add(Tile& sums, const TracedTexels& traced);
    AoStatus upload(CubeMapProjector& projector, const TracedTexels& traced, const Tile& sums,
                    int tile);
    /// Makes the code of depths span the scene as it is.
    void spanScene(CubeMapProjector& projector);

    const BackboneContext context_;
    TexelAtlas& atlas_;
    TracerQueue& queue_;
    std::vector<CubeMapProjector*> projectors_; ///< of the frame
    std::map<CubeMapId, Work> works_;
    TileTurns turns_;
    std::size_t queued_ = 0;
};

} // namespace aolib
