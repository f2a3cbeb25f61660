#include "bench/Receivers.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "raytracing/CosineSampling.h"
#include "reference/ParallelLoop.h"

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

private:
    glm::dvec3 unproject(double x, double y, double depth) const {
        const glm::dvec4 point = toWorld_ * glm::dvec4(2.0 * x - 1.0, 2.0 * y - 1.0, depth, 1.0);
        return glm::dvec3(point) / point.w;
    }

    glm::dmat4 toWorld_;
};

double aspectOf(const PictureSize& size) {
    return double(size.width) / double(size.height);
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
    const auto place = [&](std::uint32_t pixel) {
        const auto width = static_cast<std::uint32_t>(size.width);
        return glm::dvec2((double(pixel % width) + 0.5) / double(size.width),
                          (double(pixel / width) + 0.5) / double(size.height));
    };
    std::vector<Look> looks(pixels.size());
    const auto body = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const glm::dvec2 at = place(pixels[i]);
            looks[i] = rays.look(scene, at.x, at.y);
        }
    };
    parallelLoop(pixels.size(), 0, body, {});
    Receivers seen;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!looks[i].hit) {
            continue;
        }
        const Hit& hit = *looks[i].hit;
        const bool away = glm::dot(hit.normal, looks[i].direction) > 0.0;
        const glm::dvec3 normal = away ? -hit.normal : hit.normal;
        seen.pixels.push_back(pixels[i]);
        seen.points.push_back({hit.position + hit.clearance * normal, normal, 0.0});
        seen.hits.push_back(hit);
    }
    return seen;
}

Look lookThrough(const RayScene& scene, const NamedCamera& camera, double aspect, double x,
                 double y) {
    return EyeRays(camera, aspect).look(scene, x, y);
}

} // namespace aolib::bench
