#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>

#include "backbone/cubemapped/AbstractTexelSource.h"
#include "backbone/cubemapped/DeferredShading.h"

namespace aolib {

/// Texels by rasterisation: the scene is captured on a cube map's faces, and a shader looks about
/// in the capture. The capture is given back once all that is asked for is computed.
class RasterTexels final : public AbstractTexelSource {
public:
    /// Errors: ShaderError. @param radius  asks for the reach of occluders, world units.
    static Result<std::unique_ptr<AbstractTexelSource>> create(const BackboneContext& context,
                                                               const SceneGeometry& geometry,
                                                               FaceStore& store,
                                                               std::function<float()> radius);

    int passes() const override { return DeferredShading::passes(context_.options); }
    Status complete(CubeMapProjector& projector) override;
    Status advance(const std::vector<CubeMapProjector*>& projectors, double milliseconds) override;
    void forget(CubeMapId id) override { captures_.erase(id); }
    std::size_t bytes() const override;

private:
    /// Frames for which a capture is kept after its last use: a turning camera asks for more.
    static constexpr int kIdleFrames = 30;

    struct Work {
        CubeMapCapture capture;
        std::set<int> tiles;   ///< that have had passes from this capture
        std::set<int> touched; ///< of these, those with passes that are not resolved yet
        int idleFrames = 0;
    };

    RasterTexels(const BackboneContext& context, const SceneGeometry& geometry, FaceStore& store,
                 std::function<float()> radius)
        : context_(context), geometry_(geometry), store_(store), radius_(std::move(radius)) {}

    Result<Work*> workOf(CubeMapProjector& projector);
    /// One pass over tiles that need it most, at most `quota` of them. @return how many.
    int advanceTiles(CubeMapProjector& projector, Work& work, int quota);
    void resolveTouched(CubeMapProjector& projector, Work& work);
    /// Units of work for the next frame, from what earlier ones cost.
    int quota(double milliseconds);

    const BackboneContext context_;
    const SceneGeometry& geometry_;
    FaceStore& store_;
    std::function<float()> radius_;
    DeferredShading shading_;
    std::map<CubeMapId, Work> captures_;

    gl::GpuTimer timer_;
    int unitsTimed_ = 0;   ///< in the frame that the timer measures
    double unitMs_ = -1.0; ///< GPU time of a unit, smoothed; -1 until known
    int lastQuota_ = 0;
};

} // namespace aolib
