#pragma once

#include <array>
#include <cstddef>

#include <aolib/Options.h>
#include <glm/vec3.hpp>

#include "raytracing/EmbreeApi.h"
#include "raytracing/RayScene.h"

namespace aolib {

/// Sixteen rays for Embree, in the scene's frame, and the weight of what blocks each.
struct RayPacket {
    static constexpr std::size_t lanes = 16;

    RTCRayHit16 rays{};
    alignas(64) int used[lanes] = {};               ///< -1 for lanes that hold a ray, else 0
    alignas(64) int valid[lanes] = {};              ///< -1 for rays to trace, else 0
    alignas(64) std::array<float, lanes> blocked{}; ///< 0 open to 1 blocked

    /// Begins a lane's rays at `origin`.
    void setOrigin(std::size_t lane, const glm::vec3& origin) {
        rays.ray.org_x[lane] = origin.x;
        rays.ray.org_y[lane] = origin.y;
        rays.ray.org_z[lane] = origin.z;
        rays.ray.mask[lane] = ~0U;
        used[lane] = -1;
        valid[lane] = -1;
    }
};

/// Traces packets, and weighs their hits by the falloff.
class PacketTracer {
public:
    /// @param radius  world units; `Falloff::Off` ignores it. The scene must outlive the tracer.
    PacketTracer(const RayScene& scene, Falloff falloff, float radius);

    /// Loads directions into the lanes, 16 from each array on. No ray is blocked yet.
    void load(RayPacket& packet, const float* x, const float* y, const float* z) const;

    /// Traces the valid rays, and raises `blocked` to the weights w(L) of their hits.
    /// @param coherent  the rays start close together and point in similar directions.
    void trace(RayPacket& packet, bool coherent) const;

    /// Returns the weight of an occluder at a distance, frame units.
    float weight(float distance) const;

private:
    const RayScene& scene_;
    bool smooth_;  ///< occluders weigh less with distance
    float length_; ///< of rays, frame units
    float decay_;  ///< of `Falloff::Exp`: 1 / radius, per frame unit
};

} // namespace aolib
