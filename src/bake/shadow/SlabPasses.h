#pragma once

#include <span>
#include <vector>

#include <aolib/Status.h>

#include "bake/gpu/SlabTriangles.h"
#include "bake/shadow/AbstractDepthPasses.h"
#include "bake/shadow/DepthTiles.h"
#include "gl/GLSLShader.h"

namespace aolib::bake {

/// Shadow maps of occluders that reach no farther than each direction says: the scene is cut across
/// the light into slabs so thick, and each slab has two depth maps, of what in it is nearest to the
/// light, and of what in the slab before it is farthest. All of the former that is before a
/// receiver occludes it; of the latter what lies within the reach.
class SlabPasses final : public AbstractDepthPasses {
public:
    /// The vertices, which keep their triangles, must outlive it. Errors: ShaderError,
    /// MissingCapability, OutOfMemory.
    static Result<SlabPasses> create(const gl::Functions& gl, const DepthSettings& settings,
                                     const BakeVertices& vertices);

    AoStatus addDirections(std::span<const LightView> views, ReceiverSums& sums) override;
    int mapsPerPass() const override { return pairs_; }

private:
    /// Slabs of a direction that one pass holds, one after the other.
    struct Run {
        const LightView* view;
        Slabs slabs;
        int first; ///< slab
        int count;
        int pair; ///< of the first one's depth maps
    };

    SlabPasses(const gl::Functions& gl, const DepthSettings& settings, const BakeVertices& vertices)
        : gl_(&gl), settings_(settings), triangles_(gl, vertices) {}
    AoStatus drawRun(const Run& run);
    void gather(ReceiverSums& sums);

    const gl::Functions* gl_;
    DepthSettings settings_;
    SlabTriangles triangles_;
    int pairs_ = 0; ///< of depth maps
    DepthTiles tiles_;
    gl::GLSLShader gatherShader_;
    std::vector<Run> runs_; ///< of the pass that is being made
};

} // namespace aolib::bake
