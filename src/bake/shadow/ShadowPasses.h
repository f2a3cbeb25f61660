#pragma once

#include <span>

#include <aolib/Status.h>

#include "bake/gpu/BakeVertices.h"
#include "bake/shadow/AbstractDepthPasses.h"
#include "bake/shadow/DepthTiles.h"
#include "gl/GLSLShader.h"

namespace aolib::bake {

/// A depth map per direction, several side by side, then one pass over all receivers (GPU Gems,
/// chapter 17.3). Occluders have no end.
class ShadowPasses final : public AbstractDepthPasses {
public:
    /// The vertices must outlive it. Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<ShadowPasses> create(const gl::Functions& gl, const DepthSettings& settings,
                                       const BakeVertices& vertices);

    AoStatus addDirections(std::span<const LightView> views, ReceiverSums& sums) override;
    int mapsPerPass() const override { return tiles_.count(); }

private:
    ShadowPasses() = default;
    void drawDepths(std::span<const LightView> views);
    void gather(std::span<const LightView> views, ReceiverSums& sums);

    const gl::Functions* gl_ = nullptr;
    const BakeVertices* vertices_ = nullptr;
    DepthSettings settings_;
    DepthTiles tiles_;
    gl::GLSLShader gatherShader_;
};

} // namespace aolib::bake
