#include "reference/PictureTracer.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "raytracing/ShadingNormal.h"

namespace aolib {

namespace {

constexpr int largestSide = 65536;

struct EyeRay {
    glm::dvec3 origin{0.0};    ///< on the near plane, world units
    glm::dvec3 direction{0.0}; ///< unit length
    double length = 0.0;       ///< to the far plane, world units; may be infinite
};

bool finite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(matrix[column][row])) {
                return false;
            }
        }
    }
    return true;
}

AoStatus check(const PictureCamera& camera) {
    if (camera.width < 1 || camera.width > largestSide || camera.height < 1 ||
        camera.height > largestSide) {
        return {StatusCode::InvalidCamera, "a picture of " + std::to_string(camera.width) + " x " +
                                               std::to_string(camera.height) +
                                               " pixels, must be 1 to 65536 each way"};
    }
    if (!finite(camera.view) || !finite(camera.projection)) {
        return {StatusCode::InvalidCamera, "the view or projection matrix is not finite"};
    }
    if (!finite(glm::inverse(camera.view)) || !finite(glm::inverse(camera.projection))) {
        return {StatusCode::InvalidCamera, "the view or projection matrix cannot be inverted"};
    }
    return {};
}

/// Everything a pixel needs, prepared once.
class PixelTracer {
public:
    PixelTracer(const VisibilityTracer& tracer, const PictureCamera& camera, NormalSource normals)
        : tracer_(tracer), scene_(tracer.scene()), camera_(camera), normals_(normals),
          toEye_(glm::inverse(camera.projection)), toWorld_(glm::inverse(camera.view)) {}

    void trace(std::size_t pixel, Picture& picture) const;

private:
    EyeRay eyeRay(std::size_t pixel) const;

    const VisibilityTracer& tracer_;
    const RayScene& scene_;
    const PictureCamera& camera_;
    NormalSource normals_;
    glm::dmat4 toEye_;
    glm::dmat4 toWorld_;
};

/// The far point may lie at infinity (w = 0), so the direction is taken from the homogeneous
/// points: `far / far.w - near / near.w` times the positive `far.w * near.w`.
EyeRay PixelTracer::eyeRay(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(camera_.width);
    const double x = (double(pixel % width) + 0.5) / double(camera_.width) * 2.0 - 1.0;
    const double y = (double(pixel / width) + 0.5) / double(camera_.height) * 2.0 - 1.0;
    const glm::dvec4 nearPoint = toEye_ * glm::dvec4(x, y, -1.0, 1.0);
    const glm::dvec4 farPoint = toEye_ * glm::dvec4(x, y, 1.0, 1.0);
    const glm::dvec3 from = glm::dvec3(nearPoint) / nearPoint.w;
    const glm::dvec3 along = glm::dvec3(farPoint) - from * farPoint.w;
    EyeRay ray;
    ray.origin = glm::dvec3(toWorld_ * glm::dvec4(from, 1.0));
    const glm::dvec3 direction = glm::dmat3(toWorld_) * along;
    ray.direction = glm::normalize(direction);
    ray.length = farPoint.w > 0.0 ? glm::length(direction) / farPoint.w
                                  : std::numeric_limits<double>::infinity();
    return ray;
}

void PixelTracer::trace(std::size_t pixel, Picture& picture) const {
    const EyeRay ray = eyeRay(pixel);
    const std::optional<Hit> hit = scene_.intersect(ray.origin, ray.direction, 0.0, ray.length);
    if (!hit) {
        return;
    }
    const glm::dvec3 geometric =
        glm::dot(hit->normal, ray.direction) > 0.0 ? -hit->normal : hit->normal;
    const glm::dvec3 normal =
        normals_ == NormalSource::Given ? shadingNormal(scene_.mesh(), *hit, geometric) : geometric;
    const glm::dvec3 lifted = hit->position + hit->clearance * geometric;
    const VisibilityEstimate estimated = tracer_.estimate({lifted, normal, 0.0}, pixel);
    picture.visibility[pixel] = static_cast<float>(estimated.visibility);
    picture.standardError[pixel] = static_cast<float>(std::sqrt(estimated.variance));
    if (!picture.depth.empty()) {
        const glm::dvec4 eye = camera_.view * glm::dvec4(hit->position, 1.0);
        picture.depth[pixel] = static_cast<float>(-eye.z);
        picture.position[pixel] = glm::vec3(hit->position);
        picture.normal[pixel] = glm::vec3(normal);
        picture.triangle[pixel] = hit->triangle;
    }
}

} // namespace

Result<Picture> tracePicture(const RayScene& scene, const PictureCamera& camera,
                             const PictureSettings& settings, const LoopProgress& progress) {
    if (AoStatus status = check(camera); !status) {
        return status;
    }
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, settings.trace);
    if (!tracer) {
        return tracer.status();
    }
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    Picture picture;
    picture.width = camera.width;
    picture.height = camera.height;
    picture.visibility.assign(pixels, -1.0F);
    picture.standardError.assign(pixels, -1.0F);
    if (settings.surfaces) {
        picture.depth.assign(pixels, -1.0F);
        picture.position.assign(pixels, glm::vec3(0.0F));
        picture.normal.assign(pixels, glm::vec3(0.0F));
        picture.triangle.assign(pixels, 0);
    }
    const PixelTracer pixelTracer(*tracer, camera, settings.normals);
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t pixel = begin; pixel < end; ++pixel) {
            pixelTracer.trace(pixel, picture);
        }
    };
    picture.complete = parallelLoop(pixels, settings.trace.threads, body, progress);
    picture.noise = noiseOf(picture.standardError);
    return picture;
}

} // namespace aolib
