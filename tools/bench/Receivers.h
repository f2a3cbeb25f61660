#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "content/NamedCamera.h"
#include "raytracing/RayScene.h"
#include "reference/VisibilityTracer.h"

namespace aolib::bench {

/// Size of a picture, pixels.
struct PictureSize {
    int width = 960;
    int height = 540;

    std::size_t pixels() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    bool operator==(const PictureSize&) const = default;
};

/// Surface points seen through the centres of pixels; pixels that see none are left out.
struct Receivers {
    std::vector<std::uint32_t> pixels; ///< y * width + x, row 0 at the bottom, ascending
    std::vector<Receiver> points;      ///< lifted off their triangle, geometric normal to the eye
    std::vector<Hit> hits;             ///< where on which triangle
};

/// One pixel in each cell of `stride` x `stride` pixels, jittered by a seed.
std::vector<std::uint32_t> latticePixels(const PictureSize& size, int stride, std::uint64_t seed);
/// Every pixel.
std::vector<std::uint32_t> allPixels(const PictureSize& size);

/// What a camera sees in the pixels given, between its near and far plane.
Receivers findReceivers(const RayScene& scene, const NamedCamera& camera, const PictureSize& size,
                        const std::vector<std::uint32_t>& pixels);

/// Moves receivers to what a rasteriser drew in their pixels: at silhouettes its picture shows, now
/// and then, another surface than the ray through the pixel's centre meets, since it rounds
/// vertices to a grid. Where none within a 64th of a pixel has the depth that was drawn, they stay.
/// @param depths  of all pixels, 0 (the near plane) to 1; empty moves none.
/// @return which have moved.
std::vector<std::size_t> followPicture(const RayScene& scene, const NamedCamera& camera,
                                       const PictureSize& size, std::span<const float> depths,
                                       Receivers& seen);

/// What lies behind a point of the picture.
struct Look {
    glm::dvec3 direction{0.0}; ///< unit length
    std::optional<Hit> hit;    ///< nothing between the near and the far plane: empty
};

/// @param x,y  0 to 1 from the lower left corner.
Look lookThrough(const RayScene& scene, const NamedCamera& camera, double aspect, double x,
                 double y);

} // namespace aolib::bench
