#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "backbone/cubemapped/AbstractTexelSource.h"
#include "backbone/cubemapped/TracerQueue.h"

namespace aolib {

/// Texels by ray tracing: a tracer works on tiles in the background, and what it has finished is
/// uploaded. Each pass continues the rays of a tile; the GPU does nothing but take the results.
class RayTracedTexels final : public AbstractTexelSource {
public:
    RayTracedTexels(const BackboneContext& context, FaceStore& store, BlockStore& details,
                    TracerQueue& queue)
        : context_(context), store_(store), blocks_(details), queue_(queue) {}

    /// What was queued is lost: the tracer has another scene.
    void sceneChanged();
    /// The reach of occluders from now on, world units.
    void setRadius(float radius) { radius_ = radius; }

    int passes() const override;
    AoStatus complete(CubeMapProjector& projector) override;
    AoStatus advance(const std::vector<CubeMapProjector*>& projectors,
                     double milliseconds) override;
    void await(double milliseconds) override { queue_.wait(milliseconds); }
    bool lacks(const CubeMapProjector& projector) const override;
    void forget(CubeMapId id) override;

private:
    /// What has been traced of a tile, until it is complete.
    struct Tile {
        std::vector<float> sum; ///< per texel: W times rays
        int rays = 0;
    };
    struct Work {
        std::map<int, Tile> tiles;
        std::map<int, Tile> details;
        std::uint32_t generation = 0; ///< results of another are out of date
        bool spans = false;           ///< the projector's code spans the scene as it is
    };

    /// Rays per texel after a number of passes.
    int raysAfter(int passes) const;
    std::uint32_t nextGeneration();
    Work& workOf(CubeMapId id);
    /// Asks for the next pass of every tile that lacks one, the poorest first.
    void request(const std::vector<CubeMapProjector*>& projectors);
    /// Takes what is finished until the time is up.
    AoStatus takeResults(const std::vector<CubeMapProjector*>& projectors, double milliseconds);
    AoStatus take(CubeMapProjector& projector, const TracedTexels& traced, int tile);
    AoStatus takeDetail(CubeMapProjector& projector, const TracedTexels& traced, int tile);
    /// Adds a pass. @return false when it has been traced before.
    static bool add(Tile& sums, const TracedTexels& traced);
    /// Texels as they are kept.
    struct Codes {
        std::vector<std::uint8_t> visibility;
        std::vector<std::uint16_t> depth;
    };
    static Codes encode(const CubeMapProjector& projector, const TracedTexels& traced,
                        const Tile& tile);
    AoStatus upload(CubeMapProjector& projector, const TracedTexels& traced, const Tile& tile);

    const BackboneContext context_;
    FaceStore& store_;
    BlockStore& blocks_;
    TracerQueue& queue_;
    float radius_ = 1.0F;
    std::map<CubeMapId, Work> works_;
    std::uint32_t generations_ = 0;
    int askedBefore_ = 0; ///< tiles that were asked for when the queue was last filled
    std::size_t queued_ = 0;
};

} // namespace aolib
