#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/geometry/BakeGeometry.h"
#include "raytracing/HemisphereTracer.h"
#include "raytracing/PacketTracer.h"
#include "raytracing/RayScene.h"
#include "raytracing/SobolSequence.h"
#include "raytracing/SurfaceGroup.h"

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

/// Traces the hemispheres of up to 16 receivers of a bake.
class ReceiverTracer {
public:
    static constexpr std::size_t capacity = SurfaceGroup::capacity;

    /// The scene of rays must outlive the tracer.
    ReceiverTracer(const BakeGeometry& geometry, const RayScene& scene, const RayOptions& options);
    ReceiverTracer(const ReceiverTracer&) = delete;
    ReceiverTracer& operator=(const ReceiverTracer&) = delete;

    /// Traces rays `first` to `last` - 1 of each receiver.
    /// @param receivers  1 to `capacity`; `results` is as long.
    void trace(std::span<const Receiver> receivers, int first, int last,
               std::span<HemisphereSample> results);

private:
    struct Client;

    TexelSurface makeSurface(const Receiver& receiver) const;
    float heightAboveGround(const glm::vec3& origin) const;

    const RayScene& scene_;
    RayOptions options_;
    glm::vec3 up_;
    std::optional<float> ground_; ///< height along `up_`, frame units
    PacketTracer packets_;
    HemisphereTracer<Client> tracer_;
    /// Of rays, by receiver, then cell; their mean over the hemisphere is one.
    std::array<float, capacity * RayChunk::capacity> weights_{};
};

} // namespace aolib::bake
