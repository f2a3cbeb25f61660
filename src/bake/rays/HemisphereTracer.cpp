#include "bake/rays/HemisphereTracer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"
#include "raytracing/EmbreeApi.h"
#include "shared/falloff.h"
#include "shared/open_sector.h"

namespace aolib::bake {

namespace {

constexpr std::size_t lanes = HemisphereTracer::capacity;

/// Normals with at least this cosine face alike.
constexpr float alikeCosine = 0.9F;
/// Fewer receivers than this leave too many lanes of a packet empty.
constexpr std::size_t fewReceivers = 8;
/// What lies within this share of the scene's frame is taken to stand on the ground.
constexpr float groundTolerance = 1e-5F;

double frameLength(const RayScene& scene, const RayOptions& options) {
    if (options.radius <= 0.0F || options.falloff == Falloff::Off) {
        return std::numeric_limits<double>::infinity();
    }
    const double reach = options.falloff == Falloff::Exp ? double{shared::kExpReach} : 1.0;
    return reach * double{options.radius} * scene.scale();
}

} // namespace

/// Where a receiver's rays start, in the scene's frame.
struct HemisphereTracer::Start {
    glm::vec3 origin{0.0F};
    glm::mat3 basis{1.0F}; ///< the third column is the normal
    glm::vec3 plane{0.0F};
    float height = 0.0F; ///< above the ground
    SequenceSeed seed;
};

/// Embree's packet and the answer.
struct HemisphereTracer::Packet {
    RTCRayHit16 rays{};
    alignas(64) int valid[lanes] = {};
    alignas(64) std::array<float, lanes> blocked{}; ///< before tracing: by what is known already
};

HemisphereTracer::HemisphereTracer(const BakeGeometry& geometry, const RayScene& scene,
                                   const RayOptions& options)
    : scene_(scene), options_(options),
      smooth_(options.radius > 0.0F && options.falloff == Falloff::Exp),
      length_(static_cast<float>(std::min(frameLength(scene, options), 0x1p100))),
      decay_(smooth_ ? static_cast<float>(1.0 / (double{options.radius} * scene.scale())) : 0.0F),
      up_(geometry.up()) {
    if (geometry.scene().ground) {
        const glm::dvec3 point = double{*geometry.scene().ground} * geometry.up();
        ground_ = static_cast<float>(glm::dot(scene.toFrame(point), geometry.up()));
    }
}

HemisphereTracer::Start HemisphereTracer::makeStart(const Receiver& receiver) const {
    const SurfacePoint& point = receiver.point;
    const glm::dvec3 lifted =
        point.position + scene_.resolution(point.position, point.plane) * point.plane;
    Start start;
    start.origin = glm::vec3(scene_.toFrame(lifted));
    start.basis = glm::mat3(basisAbout(point.normal));
    start.plane = glm::vec3(point.plane);
    start.seed = receiver.seed;
    if (ground_) {
        start.height = glm::dot(start.origin, up_) - *ground_;
        start.height = std::abs(start.height) < groundTolerance ? 0.0F : start.height;
    }
    return start;
}

void HemisphereTracer::trace(std::span<const Receiver> receivers, int first, int last,
                             std::span<HemisphereSample> results) {
    std::array<Start, capacity> starts;
    bool alike = receivers.size() >= fewReceivers;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        starts[i] = makeStart(receivers[i]);
        alike = alike && glm::dot(starts[i].basis[2], starts[0].basis[2]) >= alikeCosine;
        results[i] = {};
    }
    const auto end = static_cast<std::uint32_t>(last);
    for (auto next = static_cast<std::uint32_t>(first); next < end;) {
        // Chunks are powers of two and start at multiples of their size.
        const std::uint32_t aligned = next == 0 ? RayChunk::capacity : next & (~next + 1);
        const std::uint32_t count =
            std::min({std::uint32_t{RayChunk::capacity}, std::bit_floor(end - next), aligned});
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            spread(starts[i], i, next, static_cast<int>(count));
        }
        traceChunk(std::span(starts).first(receivers.size()), static_cast<int>(count), alike,
                   results);
        next += count;
    }
}

/// Fills a receiver's slots with directions in the frame and with weights, whose mean over the
/// hemisphere is one.
void HemisphereTracer::spread(const Start& start, std::size_t lane, std::uint32_t first,
                              int count) {
    const auto put = [&](std::size_t cell, const glm::vec3& local, float weight) {
        const std::size_t slot = lane * RayChunk::capacity + cell;
        const glm::vec3 direction = start.basis * local;
        x_[slot] = direction.x;
        y_[slot] = direction.y;
        z_[slot] = direction.z;
        weight_[slot] = weight;
    };
    const auto size = static_cast<std::size_t>(count);
    if (options_.sampling == Sampling::Rejection) {
        RandomSequence random((std::uint64_t{start.seed.first} << 32U) | start.seed.second, first);
        for (std::size_t i = 0; i < size;) {
            const double x = 2.0 * random.next() - 1.0;
            const double y = 2.0 * random.next() - 1.0;
            const double z = random.next();
            const double length = std::sqrt(x * x + y * y + z * z);
            if (length > 1.0 || length == 0.0) {
                continue;
            }
            const glm::vec3 local(glm::dvec3(x, y, z) / length);
            put(i++, local, options_.measure == Measure::Cosine ? 2.0F * local.z : 1.0F);
        }
        return;
    }
    chunk_.fill(start.seed, first, count);
    for (std::size_t i = 0; i < size; ++i) {
        glm::vec3 local(chunk_.x[i], chunk_.y[i], chunk_.z[i]);
        if (options_.measure == Measure::SolidAngle) {
            // The disc's area r^2 becomes the height 1 - z: equal areas of the sphere.
            const float r2 = local.x * local.x + local.y * local.y;
            const float stretch = std::sqrt(std::max(0.0F, 2.0F - r2));
            local = {local.x * stretch, local.y * stretch, 1.0F - r2};
        }
        put(chunk_.cell[i], local, 1.0F);
    }
}

void HemisphereTracer::traceChunk(std::span<const Start> starts, int count, bool alike,
                                  std::span<HemisphereSample> results) {
    Packet packet;
    const auto add = [&](std::size_t lane, std::size_t receiver, std::size_t slot) {
        const float open = weight_[slot] * (1.0F - packet.blocked[lane]);
        results[receiver].visibility += open;
        const glm::vec3 direction(x_[slot], y_[slot], z_[slot]);
        results[receiver].direction += open * direction;
        if (options_.sectors) {
            const auto sector = static_cast<std::size_t>(shared::sectorOf(direction));
            results[receiver].open[sector] += open;
            results[receiver].all[sector] += weight_[slot];
        }
    };
    const auto cells = static_cast<std::size_t>(count);
    if (alike) {
        for (std::size_t cell = 0; cell < cells; ++cell) {
            for (std::size_t i = 0; i < starts.size(); ++i) {
                load(packet, i, starts[i], i * RayChunk::capacity + cell);
            }
            weigh(packet, true);
            for (std::size_t i = 0; i < starts.size(); ++i) {
                add(i, i, i * RayChunk::capacity + cell);
            }
        }
        return;
    }
    for (std::size_t i = 0; i < starts.size(); ++i) {
        for (std::size_t first = 0; first < cells; first += lanes) {
            const std::size_t slot = i * RayChunk::capacity + first;
            const std::size_t used = std::min(lanes, cells - first);
            std::fill(std::begin(packet.valid), std::end(packet.valid), 0);
            for (std::size_t lane = 0; lane < used; ++lane) {
                load(packet, lane, starts[i], slot + lane);
            }
            weigh(packet, false);
            for (std::size_t lane = 0; lane < used; ++lane) {
                add(lane, i, slot + lane);
            }
        }
    }
}

/// Weight of the ground as an occluder, 0 where the ray does not meet it.
float HemisphereTracer::groundWeight(const Start& start, const glm::vec3& direction) const {
    const float rise = glm::dot(direction, up_);
    const bool meets = start.height >= 0.0F ? rise < 0.0F : rise > 0.0F;
    if (!meets) {
        return 0.0F;
    }
    const float distance = std::abs(start.height / rise);
    if (smooth_) {
        return std::exp(-distance * decay_);
    }
    return distance < length_ ? 1.0F : 0.0F;
}

/// Puts a ray into a lane, unless what is known blocks it already.
void HemisphereTracer::load(Packet& packet, std::size_t lane, const Start& start,
                            std::size_t slot) const {
    const glm::vec3 direction(x_[slot], y_[slot], z_[slot]);
    float blocked = 0.0F;
    if (glm::dot(direction, start.plane) <= 0.0F) {
        blocked = 1.0F;
    } else if (options_.sky == Sky::Dome && glm::dot(direction, up_) < 0.0F) {
        blocked = 1.0F;
    } else if (ground_) {
        blocked = groundWeight(start, direction);
    }
    packet.blocked[lane] = blocked;
    packet.valid[lane] = blocked < 1.0F ? -1 : 0;
    RTCRay16& ray = packet.rays.ray;
    ray.org_x[lane] = start.origin.x;
    ray.org_y[lane] = start.origin.y;
    ray.org_z[lane] = start.origin.z;
    ray.dir_x[lane] = direction.x;
    ray.dir_y[lane] = direction.y;
    ray.dir_z[lane] = direction.z;
    ray.tfar[lane] = length_;
    ray.mask[lane] = ~0U;
}

/// Traces the packet's valid rays.
void HemisphereTracer::weigh(Packet& packet, bool alike) const {
    const auto coherence = alike ? embree::Coherence::Coherent : embree::Coherence::Incoherent;
    RTCRay16& ray = packet.rays.ray;
    if (smooth_) {
        std::fill_n(packet.rays.hit.geomID, lanes, RTC_INVALID_GEOMETRY_ID);
        embree::intersect(scene_.embree(), packet.valid, packet.rays, coherence);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const bool hit =
                packet.valid[lane] != 0 && packet.rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
            const float weight = hit ? std::exp(-ray.tfar[lane] * decay_) : 0.0F;
            packet.blocked[lane] = std::max(packet.blocked[lane], weight);
        }
        return;
    }
    embree::occluded(scene_.embree(), packet.valid, ray, coherence);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        if (packet.valid[lane] != 0 && ray.tfar[lane] < 0.0F) {
            packet.blocked[lane] = 1.0F;
        }
    }
}

} // namespace aolib::bake
