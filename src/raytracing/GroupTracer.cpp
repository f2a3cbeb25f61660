#include "raytracing/GroupTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "raytracing/EmbreeApi.h"
#include "shared/falloff.h"

namespace aolib {

namespace {

constexpr std::size_t lanes = SurfaceGroup::capacity;

/// Surfaces face alike when the cosine of their normals to the first one's is at least this.
constexpr float alikeCosine = 0.9F;

/// Fewer texels than this leave too many lanes of a packet empty.
constexpr std::size_t fewTexels = 8;

bool alike(const SurfaceGroup& group) {
    const glm::vec3& first = group.surfaces[0].basis[2];
    return std::all_of(group.surfaces.begin(), group.surfaces.begin() + std::ptrdiff_t(group.count),
                       [&](const TexelSurface& surface) {
                           return glm::dot(surface.basis[2], first) >= alikeCosine;
                       });
}

double frameLength(const RayScene& scene, Falloff falloff, float radius) {
    if (falloff == Falloff::Off) {
        return std::numeric_limits<double>::infinity();
    }
    const double radii = falloff == Falloff::Exp ? double{shared::kExpReach} : 1.0;
    return radii * double{radius} * scene.scale();
}

} // namespace

/// Embree's packet, whether its lanes are to be traced, and the answer.
struct GroupTracer::Packet {
    explicit Packet(bool withPlanes) : planes(withPlanes) {}

    RTCRayHit16 rays{};
    alignas(64) int valid[lanes] = {};
    alignas(64) std::array<float, lanes> weights{};
    const bool planes; ///< some lanes have planes
    alignas(64) std::array<float, lanes> planeX{};
    alignas(64) std::array<float, lanes> planeY{};
    alignas(64) std::array<float, lanes> planeZ{};
    alignas(64) std::array<int, lanes> below{}; ///< rays below them, -1 or 0
    alignas(64) std::array<int, lanes> used{};

    void setSurface(std::size_t lane, const TexelSurface& surface) {
        rays.ray.org_x[lane] = surface.origin.x;
        rays.ray.org_y[lane] = surface.origin.y;
        rays.ray.org_z[lane] = surface.origin.z;
        rays.ray.mask[lane] = ~0U;
        planeX[lane] = surface.plane.x;
        planeY[lane] = surface.plane.y;
        planeZ[lane] = surface.plane.z;
        used[lane] = -1;
        valid[lane] = -1;
    }

    /// Takes the rays below the planes out of those to be traced.
    void sortOutBelow() {
        const RTCRay16& ray = rays.ray;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const float above = ray.dir_x[lane] * planeX[lane] + ray.dir_y[lane] * planeY[lane] +
                                ray.dir_z[lane] * planeZ[lane];
            below[lane] = above < 0.0F ? used[lane] : 0;
            valid[lane] = used[lane] & ~below[lane];
        }
    }

    void closeBelow() {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            weights[lane] = below[lane] != 0 ? 1.0F : weights[lane];
        }
    }
};

GroupTracer::GroupTracer(const RayScene& scene, Falloff falloff, float radius)
    : scene_(scene), falloff_(falloff),
      length_(static_cast<float>(std::min(frameLength(scene, falloff, radius), 0x1p100))),
      decay_(static_cast<float>(1.0 / (double{radius} * scene.scale()))) {}

void GroupTracer::trace(const SurfaceGroup& group, std::uint32_t start, int count, Sums& sums) {
    const bool packetsFill = std::size_t(count) % lanes == 0;
    const bool facingAlike = alike(group);
    const bool byCell = !packetsFill || (facingAlike && group.count >= fewTexels);
    spread(group, start, count, byCell);
    if (byCell) {
        traceCells(group, count, packetsFill && facingAlike, sums);
    } else {
        traceTexels(group, count, sums);
    }
}

/// Fills the slots with directions.
void GroupTracer::spread(const SurfaceGroup& group, std::uint32_t start, int count, bool byCell) {
    const auto rays = static_cast<std::size_t>(count);
    const std::size_t texelStride = byCell ? 1 : rays;
    const std::size_t cellStride = byCell ? lanes : 1;
    if (byCell && group.count < lanes) {
        // Lanes that no texel fills are loaded, if not traced.
        std::fill_n(x_.begin(), rays * lanes, 0.0F);
        std::fill_n(y_.begin(), rays * lanes, 0.0F);
        std::fill_n(z_.begin(), rays * lanes, 0.0F);
    }
    for (std::size_t texel = 0; texel < group.count; ++texel) {
        const TexelSurface& surface = group.surfaces[texel];
        const glm::mat3 b = surface.basis;
        chunk_.fill(surface.seed, start, count);
        for (std::size_t i = 0; i < rays; ++i) {
            const float x = chunk_.x[i];
            const float y = chunk_.y[i];
            const float z = chunk_.z[i];
            chunk_.x[i] = b[0].x * x + b[1].x * y + b[2].x * z;
            chunk_.y[i] = b[0].y * x + b[1].y * y + b[2].y * z;
            chunk_.z[i] = b[0].z * x + b[1].z * y + b[2].z * z;
        }
        for (std::size_t i = 0; i < rays; ++i) {
            const std::size_t slot = texel * texelStride + chunk_.cell[i] * cellStride;
            x_[slot] = chunk_.x[i];
            y_[slot] = chunk_.y[i];
            z_[slot] = chunk_.z[i];
        }
    }
}

void GroupTracer::traceCells(const SurfaceGroup& group, int count, bool coherent, Sums& sums) {
    Packet packet(group.planes);
    for (std::size_t texel = 0; texel < group.count; ++texel) {
        packet.setSurface(texel, group.surfaces[texel]);
    }
    const auto cells = static_cast<std::size_t>(count);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        load(packet, cell * lanes);
        weigh(packet, coherent);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sums[lane] += packet.weights[lane];
        }
    }
}

void GroupTracer::traceTexels(const SurfaceGroup& group, int count, Sums& sums) {
    Packet packet(group.planes);
    const auto rays = static_cast<std::size_t>(count);
    for (std::size_t texel = 0; texel < group.count; ++texel) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            packet.setSurface(lane, group.surfaces[texel]);
        }
        for (std::size_t first = 0; first < rays; first += lanes) {
            load(packet, texel * rays + first);
            weigh(packet, false);
            for (const float weight : packet.weights) {
                sums[texel] += weight;
            }
        }
    }
}

void GroupTracer::load(Packet& packet, std::size_t slot) const {
    RTCRay16& ray = packet.rays.ray;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        ray.dir_x[lane] = x_[slot + lane];
        ray.dir_y[lane] = y_[slot + lane];
        ray.dir_z[lane] = z_[slot + lane];
        ray.tfar[lane] = length_;
    }
    if (packet.planes) {
        packet.sortOutBelow();
    }
}

/// Traces the packet's rays and weighs them.
void GroupTracer::weigh(Packet& packet, bool coherent) const {
    trace(packet, coherent);
    if (packet.planes) {
        packet.closeBelow();
    }
}

void GroupTracer::trace(Packet& packet, bool coherent) const {
    const auto coherence = coherent ? embree::Coherence::Coherent : embree::Coherence::Incoherent;
    RTCRay16& ray = packet.rays.ray;
    if (falloff_ != Falloff::Exp) {
        embree::occluded(scene_.embree(), packet.valid, ray, coherence);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            packet.weights[lane] = ray.tfar[lane] < 0.0F ? 1.0F : 0.0F;
        }
        return;
    }
    std::fill_n(packet.rays.hit.geomID, lanes, RTC_INVALID_GEOMETRY_ID);
    embree::intersect(scene_.embree(), packet.valid, packet.rays, coherence);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        packet.weights[lane] = packet.rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID
                                   ? 0.0F
                                   : std::exp(-ray.tfar[lane] * decay_);
    }
}

} // namespace aolib
