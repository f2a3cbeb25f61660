#include "bake/rays/ReceiverTracer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "raytracing/CosineSampling.h"
#include "shared/open_sector.h"

namespace aolib::bake {

namespace {

constexpr std::size_t lanes = RayPacket::lanes;

/// Receivers within this share of the scene's frame are taken to stand on the ground.
constexpr float groundTolerance = 1e-5F;

Falloff findFalloff(const RayOptions& options) {
    return options.radius > 0.0F ? options.falloff : Falloff::Off;
}

} // namespace

struct ReceiverTracer::Client {
    struct Packet : RayPacket {
        std::array<glm::vec3, lanes> plane{};
        std::array<float, lanes> height{}; ///< above the ground
    };
    static constexpr bool joinsShortChunks = false;

    const ReceiverTracer& tracer;
    std::span<HemisphereSample> results;
    std::span<float> weight; ///< as `weights_`
    std::array<float, capacity> heights{};

    void spread(const SurfaceGroup& group, std::size_t receiver, std::uint32_t first, int count,
                RayChunk& chunk) {
        const SequenceSeed& seed = group.surfaces[receiver].seed;
        float* const weights = &weight[receiver * RayChunk::capacity];
        if (tracer.options_.sampling == Sampling::Rejection) {
            spreadByRejection(seed, first, count, chunk, weights);
            return;
        }
        chunk.fill(seed, first, count);
        const auto size = static_cast<std::size_t>(count);
        std::fill_n(weights, size, 1.0F);
        if (tracer.options_.measure != Measure::SolidAngle) {
            return;
        }
        for (std::size_t i = 0; i < size; ++i) {
            // The disc's area r^2 becomes the height 1 - z: equal areas of the sphere.
            const float r2 = chunk.x[i] * chunk.x[i] + chunk.y[i] * chunk.y[i];
            const float stretch = std::sqrt(std::max(0.0F, 2.0F - r2));
            chunk.x[i] *= stretch;
            chunk.y[i] *= stretch;
            chunk.z[i] = 1.0F - r2;
        }
    }

    void spreadByRejection(const SequenceSeed& seed, std::uint32_t first, int count,
                           RayChunk& chunk, float* weights) const {
        RandomSequence random((std::uint64_t{seed.first} << 32U) | seed.second, first);
        const auto size = static_cast<std::uint32_t>(count);
        for (std::uint32_t i = 0; i < size;) {
            const double x = 2.0 * random.next() - 1.0;
            const double y = 2.0 * random.next() - 1.0;
            const double z = random.next();
            const double length = std::sqrt(x * x + y * y + z * z);
            if (length > 1.0 || length == 0.0) {
                continue;
            }
            const glm::vec3 local(glm::dvec3(x, y, z) / length);
            chunk.x[i] = local.x;
            chunk.y[i] = local.y;
            chunk.z[i] = local.z;
            chunk.cell[i] = i;
            weights[i] = tracer.options_.measure == Measure::Cosine ? 2.0F * local.z : 1.0F;
            ++i;
        }
    }

    void place(Packet& packet, std::size_t lane, const SurfaceGroup& group,
               std::size_t receiver) const {
        packet.setOrigin(lane, group.surfaces[receiver].origin);
        packet.plane[lane] = group.surfaces[receiver].plane;
        packet.height[lane] = heights[receiver];
    }

    /// Blocks rays by the receivers' planes, the dome's horizon and the ground.
    void close(Packet& packet) const {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            if (packet.used[lane] == 0) {
                continue;
            }
            const glm::vec3 direction = rayDirection(packet, lane);
            float blocked = 0.0F;
            if (glm::dot(direction, packet.plane[lane]) <= 0.0F) {
                blocked = 1.0F;
            } else if (tracer.options_.sky == Sky::Dome && glm::dot(direction, tracer.up_) < 0.0F) {
                blocked = 1.0F;
            } else if (tracer.ground_) {
                blocked = groundWeight(packet.height[lane], direction);
            }
            packet.blocked[lane] = blocked;
            packet.valid[lane] = blocked < 1.0F ? -1 : 0;
        }
    }

    /// Returns the weight of the ground as an occluder, 0 where the ray does not meet it.
    float groundWeight(float height, const glm::vec3& direction) const {
        const float rise = glm::dot(direction, tracer.up_);
        const bool meets = height >= 0.0F ? rise < 0.0F : rise > 0.0F;
        return meets ? tracer.packets_.weight(std::abs(height / rise)) : 0.0F;
    }

    void addCell(const Packet& packet, std::size_t cell) {
        for (std::size_t receiver = 0; receiver < results.size(); ++receiver) {
            add(packet, receiver, receiver, cell);
        }
    }

    void addRays(const Packet& packet, std::size_t receiver, std::size_t firstCell,
                 std::size_t count) {
        for (std::size_t lane = 0; lane < count; ++lane) {
            add(packet, lane, receiver, firstCell + lane);
        }
    }

    void add(const Packet& packet, std::size_t lane, std::size_t receiver, std::size_t cell) {
        const float all = weight[receiver * RayChunk::capacity + cell];
        const float open = all * (1.0F - packet.blocked[lane]);
        const glm::vec3 direction = rayDirection(packet, lane);
        HemisphereSample& result = results[receiver];
        result.visibility += open;
        result.direction += open * direction;
        if (tracer.options_.sectors) {
            const auto sector = static_cast<std::size_t>(shared::sectorOf(direction));
            result.open[sector] += open;
            result.all[sector] += all;
        }
    }

    static glm::vec3 rayDirection(const Packet& packet, std::size_t lane) {
        const RTCRay16& ray = packet.rays.ray;
        return {ray.dir_x[lane], ray.dir_y[lane], ray.dir_z[lane]};
    }
};

ReceiverTracer::ReceiverTracer(const BakeGeometry& geometry, const RayScene& scene,
                               const RayOptions& options)
    : scene_(scene), options_(options), up_(geometry.up()),
      packets_(scene, findFalloff(options), options.radius), tracer_(packets_) {
    if (geometry.scene().ground) {
        const glm::dvec3 point = double{*geometry.scene().ground} * geometry.up();
        ground_ = static_cast<float>(glm::dot(scene.toFrame(point), geometry.up()));
    }
}

TexelSurface ReceiverTracer::makeSurface(const Receiver& receiver) const {
    const SurfacePoint& point = receiver.point;
    const glm::dvec3 lifted =
        point.position + scene_.resolution(point.position, point.plane) * point.plane;
    return {glm::vec3(scene_.toFrame(lifted)), glm::mat3(basisAbout(point.normal)),
            glm::vec3(point.plane), receiver.seed, receiver.place};
}

float ReceiverTracer::heightAboveGround(const glm::vec3& origin) const {
    if (!ground_) {
        return 0.0F;
    }
    const float height = glm::dot(origin, up_) - *ground_;
    return std::abs(height) < groundTolerance ? 0.0F : height;
}

void ReceiverTracer::trace(std::span<const Receiver> receivers, int first, int last,
                           std::span<HemisphereSample> results) {
    SurfaceGroup group;
    Client client{*this, results.first(receivers.size()), weights_};
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        group.add(makeSurface(receivers[i]));
        client.heights[i] = heightAboveGround(group.surfaces[i].origin);
        results[i] = {};
    }
    const auto end = static_cast<std::uint32_t>(last);
    for (auto next = static_cast<std::uint32_t>(first); next < end;) {
        const std::uint32_t count = RayChunk::longest(next, end);
        tracer_.trace(group, next, static_cast<int>(count), client);
        next += count;
    }
}

} // namespace aolib::bake
