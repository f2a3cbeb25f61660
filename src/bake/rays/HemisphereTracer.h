#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/geometry/BakeGeometry.h"
#include "raytracing/RayChunk.h"
#include "raytracing/RayScene.h"

namespace aolib::bake {

/// A point whose hemisphere is traced.
struct Receiver {
    SurfacePoint point;
    SequenceSeed seed;
    std::size_t place = 0; ///< index of its result
};

/// Sums over the rays of a receiver, each with the weight that the measure gives it.
struct HemisphereSample {
    float visibility = 0.0F;   ///< sum of open rays' weights, on average 1 per open ray
    glm::vec3 direction{0.0F}; ///< weighted sum of open rays' directions; any length
    OpenSectors open{};        ///< sums of open rays' weights by sector, if `RayOptions::sectors`
    OpenSectors all{};         ///< the same sums over all rays
};

/// Traces the hemispheres of up to 16 receivers in packets of 16 rays: rays of all receivers
/// through one cell where they face alike, else neighbouring rays of one receiver.
class HemisphereTracer {
public:
    static constexpr std::size_t capacity = 16;

    /// The scene of rays must outlive the tracer.
    HemisphereTracer(const BakeGeometry& geometry, const RayScene& scene,
                     const RayOptions& options);

    /// Traces rays `first` to `last` - 1 of those that each receiver has.
    /// @param receivers  1 to `capacity`; `results` is as long.
    void trace(std::span<const Receiver> receivers, int first, int last,
               std::span<HemisphereSample> results);

private:
    struct Start;
    struct Packet;

    Start makeStart(const Receiver& receiver) const;
    void spread(const Start& start, std::size_t lane, std::uint32_t first, int count);
    void traceChunk(std::span<const Start> starts, int count, bool alike,
                    std::span<HemisphereSample> results);
    void load(Packet& packet, std::size_t lane, const Start& start, std::size_t slot) const;
    void weigh(Packet& packet, bool alike) const;
    float groundWeight(const Start& start, const glm::vec3& direction) const;

    static constexpr std::size_t slots = capacity * RayChunk::capacity;

    const RayScene& scene_;
    RayOptions options_;
    bool smooth_;  ///< occluders weigh less with distance
    float length_; ///< of rays, frame units
    float decay_;  ///< of `Falloff::Exp`: 1 / radius, per frame unit
    glm::vec3 up_;
    std::optional<float> ground_; ///< height along `up_`, frame units
    RayChunk chunk_;
    alignas(64) std::array<float, slots> x_{}; ///< of directions; slot: receiver, then cell
    alignas(64) std::array<float, slots> y_{};
    alignas(64) std::array<float, slots> z_{};
    alignas(64) std::array<float, slots> weight_{};
};

} // namespace aolib::bake
