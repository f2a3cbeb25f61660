#pragma once

#include <array>
#include <cstdint>

#include <aolib/Options.h>

#include "raytracing/HemisphereTracer.h"
#include "raytracing/PacketTracer.h"
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

    /// Adds to each texel's sum the weights w(L) of its rays from `start` on, 0 for rays that
    /// escape, 1 for those below the plane of the texel's triangle. `start` and `count` as in
    /// `RayChunk::fill()`.
    void trace(const SurfaceGroup& group, std::uint32_t start, int count, Sums& sums);

private:
    struct Client;

    PacketTracer packets_;
    HemisphereTracer<Client> tracer_;
};

} // namespace aolib
