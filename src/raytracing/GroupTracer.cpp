#include "raytracing/GroupTracer.h"

#include "raytracing/HemisphereTracer.h"
#include "raytracing/PacketTracer.h"

namespace aolib {

namespace {

constexpr std::size_t lanes = RayPacket::lanes;

} // namespace

struct GroupTracer::Client {
    struct Packet : RayPacket {
        alignas(64) std::array<float, lanes> planeX{};
        alignas(64) std::array<float, lanes> planeY{};
        alignas(64) std::array<float, lanes> planeZ{};
    };
    static constexpr bool joinsShortChunks = true;

    Sums& sums;
    const bool planes; ///< some texels have planes

    static void spread(const SurfaceGroup& group, std::size_t texel, std::uint32_t start, int count,
                       RayChunk& chunk) {
        chunk.fill(group.surfaces[texel].seed, start, count);
    }

    static void place(Packet& packet, std::size_t lane, const SurfaceGroup& group,
                      std::size_t texel) {
        const TexelSurface& surface = group.surfaces[texel];
        packet.setOrigin(lane, surface.origin);
        packet.planeX[lane] = surface.plane.x;
        packet.planeY[lane] = surface.plane.y;
        packet.planeZ[lane] = surface.plane.z;
    }

    /// Blocks the rays below the planes.
    void close(Packet& packet) const {
        if (!planes) {
            return;
        }
        const RTCRay16& ray = packet.rays.ray;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float above = ray.dir_x[lane] * packet.planeX[lane] +
                                ray.dir_y[lane] * packet.planeY[lane] +
                                ray.dir_z[lane] * packet.planeZ[lane];
            const int below = above < 0.0F ? packet.used[lane] : 0;
            packet.valid[lane] = packet.used[lane] & ~below;
            packet.blocked[lane] = below != 0 ? 1.0F : 0.0F;
        }
    }

    void addCell(const Packet& packet, std::size_t /*cell*/) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sums[lane] += packet.blocked[lane];
        }
    }

    void addRays(const Packet& packet, std::size_t texel, std::size_t /*firstCell*/,
                 std::size_t count) {
        for (std::size_t lane = 0; lane < count; ++lane) {
            sums[texel] += packet.blocked[lane];
        }
    }
};

struct GroupTracer::Content {
    PacketTracer packets;
    HemisphereTracer<Client> tracer;

    Content(const RayScene& scene, Falloff falloff, float radius)
        : packets(scene, falloff, radius), tracer(packets) {}
};

GroupTracer::GroupTracer(const RayScene& scene, Falloff falloff, float radius)
    : content_(std::make_unique<Content>(scene, falloff, radius)) {}

GroupTracer::~GroupTracer() = default;

void GroupTracer::trace(const SurfaceGroup& group, std::uint32_t start, int count, Sums& sums) {
    Client client{sums, group.planes};
    content_->tracer.trace(group, start, count, client);
}

} // namespace aolib
