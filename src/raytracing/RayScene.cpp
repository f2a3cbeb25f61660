#include "raytracing/RayScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raytracing/EmbreeApi.h"
#include "scene/Bounds.h"

namespace aolib {

namespace {

/// Half an ulp of a float near 1: the relative error of one rounding.
constexpr double unitRoundoff = 0x1p-24;

/// Roundings between a surface and the ray that leaves it: of the triangle's three vertices, of
/// the origin, and of the terms of Embree's edge and plane tests. Twice that many are allowed for.
constexpr double roundings = 16.0;

/// The least clearance, in the scene's frame: where a plane goes exactly through the origin nothing
/// is rounded, but a ray may still not start on it.
constexpr double leastClearance = 0x1p-40;

/// The scene lies within [-1, 1]^3 of its frame, and so within this distance of its centre.
constexpr double reach = 2.0;

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct GeometryRelease {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<RTCDeviceTy, DeviceRelease>;
using Scene = std::unique_ptr<RTCSceneTy, SceneRelease>;
using Geometry = std::unique_ptr<RTCGeometryTy, GeometryRelease>;

RTCRay embreeRay(const FrameRay& from) {
    RTCRay ray{};
    ray.org_x = from.origin.x;
    ray.org_y = from.origin.y;
    ray.org_z = from.origin.z;
    ray.dir_x = from.direction.x;
    ray.dir_y = from.direction.y;
    ray.dir_z = from.direction.z;
    ray.tfar = from.length;
    ray.mask = ~0U;
    return ray;
}

/// Embree's callback during a build. Called from its threads.
bool goesOn(void* keepGoing, double /*fraction*/) {
    return (*static_cast<const KeepGoing*>(keepGoing))();
}

bool finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

AoStatus check(const TriangleMesh& mesh) {
    if (mesh.indices.size() % 3 != 0) {
        return {StatusCode::IncompletePrimitive,
                std::to_string(mesh.indices.size()) + " indices are not whole triangles"};
    }
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (mesh.indices[i] >= mesh.positions.size()) {
            return {StatusCode::InvalidIndex,
                    "index " + std::to_string(i) + " is " + std::to_string(mesh.indices[i]) +
                        " of only " + std::to_string(mesh.positions.size()) + " vertices"};
        }
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (!finite(mesh.positions[i])) {
            return {StatusCode::InvalidPosition,
                    "position " + std::to_string(i) + " is not finite"};
        }
    }
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) {
        return {StatusCode::InvalidNormal, std::to_string(mesh.normals.size()) + " normals for " +
                                               std::to_string(mesh.positions.size()) +
                                               " positions"};
    }
    for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        if (!finite(mesh.normals[i])) {
            return {StatusCode::InvalidNormal, "normal " + std::to_string(i) + " is not finite"};
        }
    }
    return {};
}

} // namespace

struct RayScene::Content {
    explicit Content(TriangleMesh given) : mesh(std::move(given)) { chooseFrame(); }

    void chooseFrame();
    AoStatus build(const KeepGoing& keepGoing);
    AoStatus failure(RTCError code) const;
    bool fillGeometry(RTCGeometry geometry) const;
    std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const;
    glm::dvec3 toFrame(const glm::dvec3& p) const { return (p - centre) * scale; }

    TriangleMesh mesh;
    std::vector<std::uint32_t> triangles; ///< the mesh's triangle behind each of Embree's
    glm::dvec3 centre{0.0};               ///< world units
    double scale = 1.0;                   ///< a power of two, frame units per world unit
    glm::dvec3 halfExtent{0.0};           ///< world units
    Device device;
    Scene scene;
};

void RayScene::Content::chooseFrame() {
    Bounds bounds;
    for (const glm::vec3& p : mesh.positions) {
        bounds.include(p);
    }
    if (bounds.empty()) {
        return;
    }
    centre = 0.5 * (glm::dvec3(bounds.min) + glm::dvec3(bounds.max));
    halfExtent = 0.5 * (glm::dvec3(bounds.max) - glm::dvec3(bounds.min));
    const double largest = std::max({halfExtent.x, halfExtent.y, halfExtent.z});
    if (largest > 0.0) {
        scale = std::exp2(-std::ceil(std::log2(largest)));
    }
}

std::array<glm::dvec3, 3> RayScene::Content::corners(std::uint32_t triangle) const {
    const std::uint32_t* index = &mesh.indices[std::size_t{triangle} * 3];
    return {glm::dvec3(mesh.positions[index[0]]), glm::dvec3(mesh.positions[index[1]]),
            glm::dvec3(mesh.positions[index[2]])};
}

AoStatus RayScene::Content::failure(RTCError code) const {
    if (code == RTC_ERROR_UNSUPPORTED_CPU) {
        return {StatusCode::MissingCapability, "Embree does not run on this processor"};
    }
    return {StatusCode::OutOfMemory, "Embree failed with error " +
                                         std::to_string(static_cast<int>(code)) + " on " +
                                         std::to_string(mesh.triangleCount()) + " triangles"};
}

bool RayScene::Content::fillGeometry(RTCGeometry geometry) const {
    auto* vertices = static_cast<glm::vec3*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(glm::vec3), mesh.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), triangles.size()));
    if (vertices == nullptr || indices == nullptr) {
        return false;
    }
    for (const glm::vec3& p : mesh.positions) {
        *vertices++ = glm::vec3(toFrame(glm::dvec3(p)));
    }
    for (const std::uint32_t t : triangles) {
        indices = std::copy_n(&mesh.indices[std::size_t{t} * 3], 3, indices);
    }
    return true;
}

AoStatus RayScene::Content::build(const KeepGoing& keepGoing) {
    device.reset(rtcNewDevice(nullptr));
    if (!device) {
        return failure(rtcGetDeviceError(nullptr));
    }
    for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
        const std::array<glm::dvec3, 3> p = corners(t);
        const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (area != glm::dvec3(0.0)) {
            triangles.push_back(t);
        }
    }
    scene.reset(rtcNewScene(device.get()));
    if (!scene) {
        return failure(rtcGetDeviceError(device.get()));
    }
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene.get(), RTC_BUILD_QUALITY_HIGH);
    if (!triangles.empty()) {
        const Geometry geometry(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
        if (!geometry || !fillGeometry(geometry.get())) {
            return failure(rtcGetDeviceError(device.get()));
        }
        rtcCommitGeometry(geometry.get());
        rtcAttachGeometry(scene.get(), geometry.get());
    }
    KeepGoing asked = keepGoing;
    if (asked) {
        rtcSetSceneProgressMonitorFunction(scene.get(), goesOn, &asked);
    }
    rtcCommitScene(scene.get());
    rtcSetSceneProgressMonitorFunction(scene.get(), nullptr, nullptr);
    const RTCError code = rtcGetDeviceError(device.get());
    return code == RTC_ERROR_NONE ? AoStatus() : failure(code);
}

RayScene::RayScene(std::unique_ptr<Content> content) : content_(std::move(content)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(TriangleMesh mesh, const KeepGoing& keepGoing) {
    if (AoStatus status = check(mesh); !status) {
        return status;
    }
    auto content = std::make_unique<Content>(std::move(mesh));
    if (AoStatus status = content->build(keepGoing); !status) {
        return status;
    }
    return RayScene(std::move(content));
}

FrameRay RayScene::frameRay(const glm::dvec3& origin, const glm::dvec3& direction, double tmin,
                            double tmax) const {
    const glm::dvec3 d = glm::normalize(direction);
    const glm::dvec3 o = content_->toFrame(origin);
    const double start = std::max(tmin * content_->scale, -glm::dot(o, d) - reach);
    const double length = tmax * content_->scale - start;
    FrameRay ray;
    ray.origin = glm::vec3(start == 0.0 ? o : o + d * start);
    ray.direction = glm::vec3(d);
    ray.length = length < double{std::numeric_limits<float>::max()}
                     ? static_cast<float>(length)
                     : std::numeric_limits<float>::infinity();
    ray.empty = !(length > 0.0);
    return ray;
}

Hit RayScene::rebuilt(const FrameHit& from, const glm::dvec3& origin,
                      const glm::dvec3& direction) const {
    Hit hit;
    hit.triangle = content_->triangles[from.primitive];
    hit.u = double{from.u};
    hit.v = double{from.v};
    const std::array<glm::dvec3, 3> p = content_->corners(hit.triangle);
    hit.position = p[0] + hit.u * (p[1] - p[0]) + hit.v * (p[2] - p[0]);
    hit.normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    hit.distance = glm::dot(hit.position - origin, glm::normalize(direction));
    const glm::dvec3 largest =
        glm::max(glm::abs(p[0] - content_->centre),
                 glm::max(glm::abs(p[1] - content_->centre), glm::abs(p[2] - content_->centre)));
    hit.clearance = roundings * unitRoundoff * glm::dot(glm::abs(hit.normal), largest) +
                    leastClearance / content_->scale;
    return hit;
}

std::optional<Hit> RayScene::intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                                       double tmin, double tmax) const {
    const FrameRay from = frameRay(origin, direction, tmin, tmax);
    if (from.empty) {
        return std::nullopt;
    }
    RTCRayHit rayHit{};
    rayHit.ray = embreeRay(from);
    rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayHit.hit.primID = RTC_INVALID_GEOMETRY_ID;
    embree::intersect(content_->scene.get(), rayHit);
    if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return std::nullopt;
    }
    return rebuilt({rayHit.hit.primID, rayHit.hit.u, rayHit.hit.v}, origin, direction);
}

bool RayScene::occluded(const glm::dvec3& origin, const glm::dvec3& direction, double tmin,
                        double tmax) const {
    const FrameRay from = frameRay(origin, direction, tmin, tmax);
    if (from.empty) {
        return false;
    }
    RTCRay ray = embreeRay(from);
    embree::occluded(content_->scene.get(), ray);
    return ray.tfar < 0.0F;
}

glm::dvec3 RayScene::toFrame(const glm::dvec3& position) const {
    return content_->toFrame(position);
}

double RayScene::scale() const {
    return content_->scale;
}

RTCSceneTy* RayScene::embree() const {
    return content_->scene.get();
}

double RayScene::resolution(const glm::dvec3& position, const glm::dvec3& normal) const {
    const glm::dvec3 inFrame =
        glm::max(content_->halfExtent, glm::abs(position - content_->centre));
    return roundings * unitRoundoff * glm::dot(glm::abs(normal), inFrame) +
           leastClearance / content_->scale;
}

double RayScene::clearance(const glm::dvec3& position, const glm::dvec3& normal) const {
    return resolution(position, normal) +
           2.0 * unitRoundoff * glm::dot(glm::abs(normal), glm::abs(position));
}

const TriangleMesh& RayScene::mesh() const {
    return content_->mesh;
}

} // namespace aolib
