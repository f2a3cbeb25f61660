#include "raytracing/SurfaceFinder.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "raytracing/EmbreeApi.h"
#include "raytracing/ShadingNormal.h"
#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Sine of the angle to a plane below which a ray does not determine its intersection.
constexpr double leastSlope = 1e-3;

} // namespace

SurfaceFinder::SurfaceFinder(const RayScene& scene, const TexelRequest& request)
    : scene_(scene), request_(request), centre_(request.centre),
      nearest_(scene.resolution(centre_, glm::dvec3(1.0))),
      forward_(shared::faceForward(request.face)), right_(shared::faceRight(request.face)),
      up_(shared::faceUp(request.face)) {}

SurfaceFinder::Ray SurfaceFinder::ray(const Texel& texel) const {
    if (!request_.primaryRays.empty()) {
        const LineOfSight& line =
            request_.primaryRays[static_cast<std::size_t>(texel.y) *
                                     static_cast<std::size_t>(request_.width) +
                                 static_cast<std::size_t>(texel.x)];
        const glm::dvec3 along = glm::dvec3(line.to) - glm::dvec3(line.from);
        const double length = glm::length(along);
        return {centre_ + glm::dvec3(line.from), along / length, 0.0, length};
    }
    const double u = (2.0 * (request_.x + texel.x) + 1.0) / request_.faceSize - 1.0;
    const double v = (2.0 * (request_.y + texel.y) + 1.0) / request_.faceSize - 1.0;
    return {centre_, glm::normalize(forward_ + u * right_ + v * up_), nearest_,
            std::numeric_limits<double>::infinity()};
}

/// Barycentrics are off by a rounding of the triangle's size, which may be that of the scene. In
/// its plane, which is exact, the ray says where the point is, unless it runs along the plane.
SurfaceFinder::Seen SurfaceFinder::seen(const Hit& hit, const Ray& ray) const {
    const double slope = glm::dot(hit.normal, ray.direction);
    const glm::dvec3 facing = slope > 0.0 ? -hit.normal : hit.normal;
    Seen result{hit, facing, shadingNormal(scene_.mesh(), hit, facing), ray.direction};
    if (std::abs(slope) > leastSlope) {
        result.hit.distance = glm::dot(hit.position - ray.origin, hit.normal) / slope;
        result.hit.position = ray.origin + result.hit.distance * ray.direction;
    }
    return result;
}

SurfaceFinder::SeenList SurfaceFinder::find(std::span<const Texel> texels) const {
    std::array<Ray, packet> primaryRays;
    alignas(64) int valid[packet] = {};
    RTCRayHit16 rays{};
    for (std::size_t i = 0; i < texels.size(); ++i) {
        primaryRays[i] = ray(texels[i]);
        const FrameRay ray = scene_.frameRay(primaryRays[i].origin, primaryRays[i].direction,
                                             primaryRays[i].nearest, primaryRays[i].farthest);
        valid[i] = ray.empty ? 0 : -1;
        rays.ray.org_x[i] = ray.origin.x;
        rays.ray.org_y[i] = ray.origin.y;
        rays.ray.org_z[i] = ray.origin.z;
        rays.ray.dir_x[i] = ray.direction.x;
        rays.ray.dir_y[i] = ray.direction.y;
        rays.ray.dir_z[i] = ray.direction.z;
        rays.ray.tfar[i] = ray.length;
        rays.ray.mask[i] = ~0U;
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    embree::intersect(scene_.embree(), valid, rays, embree::Coherence::Coherent);
    SeenList list;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        if (valid[i] == 0 || rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
            continue;
        }
        const Hit hit = scene_.rebuilt({rays.hit.primID[i], rays.hit.u[i], rays.hit.v[i]},
                                       primaryRays[i].origin, primaryRays[i].direction);
        list[i] = seen(hit, primaryRays[i]);
    }
    return list;
}

} // namespace aolib
