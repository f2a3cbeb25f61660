#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <aolib/Options.h>

#include "raytracing/RayChunk.h"
#include "raytracing/RayScene.h"
#include "raytracing/SurfaceGroup.h"

namespace aolib {

/// Traces the rays of a group of texels in packets of 16, made of rays that are alike: where the
/// surfaces face alike, all texels' rays through one cell of the hemisphere; else rays of one texel
/// through neighbouring cells. Packets of the former kind are traced two to four times as fast as
/// single rays.
class GroupTracer {
public:
    using Sums = std::array<float, SurfaceGroup::capacity>;

    /// @param radius  world units. The scene must outlive the tracer.
    GroupTracer(const RayScene& scene, Falloff falloff, float radius);

    /// Adds to each texel's sum the weights w(L) of its rays from `start` on, 0 for rays that
    /// escape, 1 for those below the plane of the texel's triangle. `start` and `count` as in
    /// `RayChunk::fill()`.
    void trace(const SurfaceGroup& group, std::uint32_t start, int count, Sums& sums);

private:
    struct Packet;

    void spread(const SurfaceGroup& group, std::uint32_t start, int count, bool byCell);
    void traceCells(const SurfaceGroup& group, int count, bool coherent, Sums& sums);
    void traceTexels(const SurfaceGroup& group, int count, Sums& sums);
    void load(Packet& packet, std::size_t slot) const;
    void weigh(Packet& packet, bool coherent) const;
    void trace(Packet& packet, bool coherent) const;

    static constexpr std::size_t slots = SurfaceGroup::capacity * RayChunk::capacity;

    const RayScene& scene_;
    Falloff falloff_;
    float length_; ///< of rays, frame units
    float decay_;  ///< of `Falloff::Exp`: 1 / radius, per frame unit
    RayChunk chunk_;
    /// Directions in the frame. A slot is (cell, texel) or (texel, cell), the second running
    /// faster.
    alignas(64) std::array<float, slots> x_{};
    alignas(64) std::array<float, slots> y_{};
    alignas(64) std::array<float, slots> z_{};
};

} // namespace aolib
