#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "raytracing/PacketTracer.h"
#include "raytracing/RayChunk.h"
#include "raytracing/SurfaceGroup.h"

namespace aolib {

/// Traces the hemispheres of a group of surfaces in packets of 16 similar rays. If the surfaces
/// face alike, a packet has the rays of all surfaces through one cell of the hemisphere; else it
/// has rays of one surface through neighbouring cells. Packets of the former kind are traced two to
/// four times as fast as single rays.
///
/// @tparam Client  the cube maps' or the bakers' part:
/// - `Packet`: a RayPacket, and what else `close()` reads of its lanes;
/// - `joinsShortChunks`: chunks of less than 16 rays are traced cell by cell, however surfaces
/// face;
/// - `spread(group, surface, start, count, chunk)`: fills the chunk with directions about +z;
/// - `place(packet, lane, group, surface)`: puts a surface into a lane;
/// - `close(packet)`: blocks rays that need no tracing: sets their `blocked`, clears their `valid`;
/// - `addCell(packet, cell)`: adds the rays of all surfaces through a cell;
/// - `addRays(packet, surface, firstCell, count)`: adds rays of one surface.
template <typename Client>
class HemisphereTracer {
public:
    explicit HemisphereTracer(const PacketTracer& packets) : packets_(packets) {}

    /// Traces rays `start` to `start + count - 1` of each surface. `start` and `count` as in
    /// `RayChunk::fill()`.
    void trace(const SurfaceGroup& group, std::uint32_t start, int count, Client& client) {
        const bool packetsFill = std::size_t(count) % lanes == 0;
        const bool alike = faceAlike(group);
        const bool joined = Client::joinsShortChunks && !packetsFill;
        const bool byCell = joined || (alike && group.count >= fewSurfaces);
        spread(group, start, count, byCell, client);
        if (byCell) {
            traceCells(group, count, alike && !joined, client);
        } else {
            traceSurfaces(group, count, client);
        }
    }

private:
    static constexpr std::size_t lanes = RayPacket::lanes;
    static_assert(lanes == SurfaceGroup::capacity);
    static constexpr std::size_t slots = lanes * RayChunk::capacity;
    /// Surfaces face alike when the cosine of their normals to the first one's is at least this.
    static constexpr float alikeCosine = 0.9F;
    /// Fewer surfaces than this leave too many lanes of a packet empty.
    static constexpr std::size_t fewSurfaces = 8;

    static bool faceAlike(const SurfaceGroup& group) {
        const glm::vec3& first = group.surfaces[0].basis[2];
        const auto end = group.surfaces.begin() + std::ptrdiff_t(group.count);
        return std::all_of(group.surfaces.begin(), end, [&](const TexelSurface& surface) {
            return glm::dot(surface.basis[2], first) >= alikeCosine;
        });
    }

    /// Fills the slots with directions in the scene's frame.
    void spread(const SurfaceGroup& group, std::uint32_t start, int count, bool byCell,
                Client& client) {
        const auto rays = static_cast<std::size_t>(count);
        const std::size_t surfaceStride = byCell ? 1 : rays;
        const std::size_t cellStride = byCell ? lanes : 1;
        if (byCell && group.count < lanes) {
            // Lanes that no surface fills are loaded, if not traced.
            std::fill_n(x_.begin(), rays * lanes, 0.0F);
            std::fill_n(y_.begin(), rays * lanes, 0.0F);
            std::fill_n(z_.begin(), rays * lanes, 0.0F);
        }
        for (std::size_t surface = 0; surface < group.count; ++surface) {
            const glm::mat3 b = group.surfaces[surface].basis;
            client.spread(group, surface, start, count, chunk_);
            for (std::size_t i = 0; i < rays; ++i) {
                const float x = chunk_.x[i];
                const float y = chunk_.y[i];
                const float z = chunk_.z[i];
                chunk_.x[i] = b[0].x * x + b[1].x * y + b[2].x * z;
                chunk_.y[i] = b[0].y * x + b[1].y * y + b[2].y * z;
                chunk_.z[i] = b[0].z * x + b[1].z * y + b[2].z * z;
            }
            for (std::size_t i = 0; i < rays; ++i) {
                const std::size_t slot = surface * surfaceStride + chunk_.cell[i] * cellStride;
                x_[slot] = chunk_.x[i];
                y_[slot] = chunk_.y[i];
                z_[slot] = chunk_.z[i];
            }
        }
    }

    void traceCells(const SurfaceGroup& group, int count, bool coherent, Client& client) {
        typename Client::Packet packet;
        for (std::size_t surface = 0; surface < group.count; ++surface) {
            client.place(packet, surface, group, surface);
        }
        const auto cells = static_cast<std::size_t>(count);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            tracePacket(packet, cell * lanes, coherent, client);
            client.addCell(packet, cell);
        }
    }

    void traceSurfaces(const SurfaceGroup& group, int count, Client& client) {
        typename Client::Packet packet;
        const auto rays = static_cast<std::size_t>(count);
        const std::size_t filled = std::min(lanes, rays);
        for (std::size_t surface = 0; surface < group.count; ++surface) {
            for (std::size_t lane = 0; lane < filled; ++lane) {
                client.place(packet, lane, group, surface);
            }
            for (std::size_t first = 0; first < rays; first += lanes) {
                tracePacket(packet, surface * rays + first, false, client);
                client.addRays(packet, surface, first, filled);
            }
        }
    }

    template <typename Packet>
    void tracePacket(Packet& packet, std::size_t slot, bool coherent, const Client& client) const {
        packets_.load(packet, &x_[slot], &y_[slot], &z_[slot]);
        client.close(packet);
        packets_.trace(packet, coherent);
    }

    const PacketTracer& packets_;
    RayChunk chunk_;
    /// Directions. A slot is (cell, surface) or (surface, cell), the second running faster. A short
    /// chunk's last packet is loaded as a whole.
    alignas(64) std::array<float, slots + lanes> x_{};
    alignas(64) std::array<float, slots + lanes> y_{};
    alignas(64) std::array<float, slots + lanes> z_{};
};

} // namespace aolib
