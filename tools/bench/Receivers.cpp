#include "bench/Receivers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "parallel/ParallelLoop.h"
#include "raytracing/CosineSampling.h"

namespace aolib::bench {

namespace {

/// The rays of a camera, from the near plane to the far plane.
class EyeRays {
public:
    EyeRays(const NamedCamera& camera, double aspect)
        : toWorld_(glm::inverse(glm::dmat4(projectionMatrix(camera, static_cast<float>(aspect))) *
                                glm::dmat4(viewMatrix(camera)))) {}

    /// @param x,y  0 to 1.
    Look look(const RayScene& scene, double x, double y) const {
        const glm::dvec3 from = unproject(x, y, -1.0);
        const glm::dvec3 along = unproject(x, y, 1.0) - from;
        const double length = glm::length(along);
        return {along / length, scene.intersect(from, along, 0.0, length)};
    }

    /// @param depth  -1 (the near plane) to 1.
    glm::dvec3 unproject(double x, double y, double depth) const {
        const glm::dvec4 point = toWorld_ * glm::dvec4(2.0 * x - 1.0, 2.0 * y - 1.0, depth, 1.0);
        return glm::dvec3(point) / point.w;
    }

private:
    glm::dmat4 toWorld_;
};

double aspectOf(const PictureSize& size) {
    return double(size.width) / double(size.height);
}

/// The centre of a pixel, 0 to 1.
glm::dvec2 centreOf(std::uint32_t pixel, const PictureSize& size) {
    const auto width = static_cast<std::uint32_t>(size.width);
    return glm::dvec2((double(pixel % width) + 0.5) / double(size.width),
                      (double(pixel / width) + 0.5) / double(size.height));
}

Receiver receiverAt(const Hit& hit, const glm::dvec3& direction) {
    const bool away = glm::dot(hit.normal, direction) > 0.0;
    const glm::dvec3 normal = away ? -hit.normal : hit.normal;
    return {hit.position + hit.clearance * normal, normal, 0.0};
}

/// What a rasteriser drew in a pixel.
struct Drawn {
    glm::dvec3 position;
    glm::dvec3 along; ///< unit vector away from the eye
    double tolerance; ///< of depth within which it is the same surface, world units

    /// How far a hit is before or behind it.
    double depthTo(const Hit& hit) const {
        return std::abs(glm::dot(hit.position - position, along));
    }
};

Drawn drawnAt(const EyeRays& rays, const glm::dvec2& at, const PictureSize& size, float depth) {
    constexpr double kResolution = 0x1p-22; // of a depth buffer with 24 bits, between -1 and 1
    const double z = 2.0 * double{depth} - 1.0;
    const glm::dvec3 position = rays.unproject(at.x, at.y, z);
    const glm::dvec3 nearer = rays.unproject(at.x, at.y, z - kResolution);
    const glm::dvec3 beside = rays.unproject(at.x + 1.0 / double(size.width), at.y, z);
    return {position, glm::normalize(position - rays.unproject(at.x, at.y, -1.0)),
            0.5 * glm::distance(position, beside) + glm::distance(position, nearer)};
}

/// The surface nearest to the drawn one, by rays a hair beside the pixel's centre.
std::optional<Look> lookAbout(const RayScene& scene, const EyeRays& rays, const glm::dvec2& at,
                              const PictureSize& size, const Drawn& drawn) {
    constexpr double kHair = 1.0 / 64.0; // of a pixel; rasterisers round vertices to 1/256 or 1/16
    std::optional<Look> best;
    for (int i = 0; i < 9; ++i) {
        const double x = at.x + kHair * double(i % 3 - 1) / double(size.width);
        const double y = at.y + kHair * double(i / 3 - 1) / double(size.height);
        const Look look = rays.look(scene, x, y);
        const double most = best ? drawn.depthTo(*best->hit) : drawn.tolerance;
        if (look.hit && drawn.depthTo(*look.hit) <= most) {
            best = look;
        }
    }
    return best;
}

} // namespace

std::vector<std::uint32_t> latticePixels(const PictureSize& size, int stride, std::uint64_t seed) {
    std::vector<std::uint32_t> pixels;
    std::uint64_t cell = 0;
    for (int row = 0; row < size.height; row += stride) {
        for (int column = 0; column < size.width; column += stride) {
            RandomSequence random(seed, cell++);
            const int wide = std::min(stride, size.width - column);
            const int high = std::min(stride, size.height - row);
            const int x = column + static_cast<int>(random.next() * wide);
            const int y = row + static_cast<int>(random.next() * high);
            pixels.push_back(static_cast<std::uint32_t>(y * size.width + x));
        }
    }
    std::sort(pixels.begin(), pixels.end());
    return pixels;
}

std::vector<std::uint32_t> allPixels(const PictureSize& size) {
    std::vector<std::uint32_t> pixels(size.pixels());
    std::iota(pixels.begin(), pixels.end(), 0U);
    return pixels;
}

Receivers findReceivers(const RayScene& scene, const NamedCamera& camera, const PictureSize& size,
                        const std::vector<std::uint32_t>& pixels) {
    const EyeRays rays(camera, aspectOf(size));
    std::vector<Look> looks(pixels.size());
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec2 at = centreOf(pixels[i], size);
            looks[i] = rays.look(scene, at.x, at.y);
        }
    };
    parallelLoop(pixels.size(), 0, body, {});
    Receivers seen;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!looks[i].hit) {
            continue;
        }
        seen.pixels.push_back(pixels[i]);
        seen.points.push_back(receiverAt(*looks[i].hit, looks[i].direction));
        seen.hits.push_back(*looks[i].hit);
    }
    return seen;
}

std::vector<std::size_t> followPicture(const RayScene& scene, const NamedCamera& camera,
                                       const PictureSize& size, std::span<const float> depths,
                                       Receivers& seen) {
    const EyeRays rays(camera, aspectOf(size));
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < seen.pixels.size() && !depths.empty(); ++i) {
        const glm::dvec2 at = centreOf(seen.pixels[i], size);
        const Drawn drawn = drawnAt(rays, at, size, depths[seen.pixels[i]]);
        if (drawn.depthTo(seen.hits[i]) <= drawn.tolerance) {
            continue;
        }
        if (const std::optional<Look> look = lookAbout(scene, rays, at, size, drawn)) {
            seen.points[i] = receiverAt(*look->hit, look->direction);
            seen.hits[i] = *look->hit;
            moved.push_back(i);
        }
    }
    return moved;
}

Look lookThrough(const RayScene& scene, const NamedCamera& camera, double aspect, double x,
                 double y) {
    return EyeRays(camera, aspect).look(scene, x, y);
}

} // namespace aolib::bench
