#include "raytracing/PacketTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/falloff.h"

namespace aolib {

namespace {

constexpr std::size_t lanes = RayPacket::lanes;

double frameLength(const RayScene& scene, Falloff falloff, float radius) {
    if (falloff == Falloff::Off) {
        return std::numeric_limits<double>::infinity();
    }
    const double radii = falloff == Falloff::Exp ? double{shared::kExpReach} : 1.0;
    return radii * double{radius} * scene.scale();
}

} // namespace

PacketTracer::PacketTracer(const RayScene& scene, Falloff falloff, float radius)
    : scene_(scene), smooth_(falloff == Falloff::Exp),
      length_(static_cast<float>(std::min(frameLength(scene, falloff, radius), 0x1p100))),
      decay_(smooth_ ? static_cast<float>(1.0 / (double{radius} * scene.scale())) : 0.0F) {}

void PacketTracer::load(RayPacket& packet, const float* x, const float* y, const float* z) const {
    RTCRay16& ray = packet.rays.ray;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        ray.dir_x[lane] = x[lane];
        ray.dir_y[lane] = y[lane];
        ray.dir_z[lane] = z[lane];
        ray.tfar[lane] = length_;
        packet.blocked[lane] = 0.0F;
    }
}

void PacketTracer::trace(RayPacket& packet, bool coherent) const {
    const auto coherence = coherent ? embree::Coherence::Coherent : embree::Coherence::Incoherent;
    RTCRay16& ray = packet.rays.ray;
    if (!smooth_) {
        embree::occluded(scene_.embree(), packet.valid, ray, coherence);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            packet.blocked[lane] = ray.tfar[lane] < 0.0F ? 1.0F : packet.blocked[lane];
        }
        return;
    }
    std::fill_n(packet.rays.hit.geomID, lanes, RTC_INVALID_GEOMETRY_ID);
    embree::intersect(scene_.embree(), packet.valid, packet.rays, coherence);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const bool hit = packet.rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
        const float found = hit ? std::exp(-ray.tfar[lane] * decay_) : 0.0F;
        packet.blocked[lane] = std::max(packet.blocked[lane], found);
    }
}

float PacketTracer::weight(float distance) const {
    if (smooth_) {
        return std::exp(-distance * decay_);
    }
    return distance < length_ ? 1.0F : 0.0F;
}

} // namespace aolib
