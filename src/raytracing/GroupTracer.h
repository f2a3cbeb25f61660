#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <aolib/Options.h>

#include "raytracing/RayScene.h"
#include "raytracing/SurfaceGroup.h"

namespace aolib {

/// Sums up what blocks the hemispheres of a group of texels of cube maps.
class GroupTracer {
public:
    using Sums = std::array<float, SurfaceGroup::capacity>;

    /// @param radius  world units. The scene must outlive the tracer.
    GroupTracer(const RayScene& scene, Falloff falloff, float radius);
    GroupTracer(const GroupTracer&) = delete;
    GroupTracer& operator=(const GroupTracer&) = delete;
    ~GroupTracer();

    /// Adds to each texel's sum the weights w(L) of its rays from `start` on, 0 for rays that
    /// escape, 1 for those below the plane of the texel's triangle. `start` and `count` as in
    /// `RayChunk::fill()`.
    void trace(const SurfaceGroup& group, std::uint32_t start, int count, Sums& sums);

private:
    struct Client;
    struct Content; ///< with types of Embree, which users of this header may lack

    std::unique_ptr<Content> content_;
};

} // namespace aolib
