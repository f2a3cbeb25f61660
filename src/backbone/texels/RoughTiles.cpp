#include "backbone/texels/RoughTiles.h"

#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Two neighbouring texels are one surface when the second lies on the first's tangent plane to
/// within this many footprints, their normals agree by this cosine, and W by this much.
constexpr float kSmoothFootprints = 0.5F;
constexpr float kSmoothCosine = 0.94F;
constexpr float kSmoothVisibility = 0.3F;

} // namespace

bool isRough(const TracedTexels& traced) {
    const TexelRequest& request = traced.request;
    const auto pointAt = [&](std::size_t i) {
        const glm::vec2 at(request.x + static_cast<int>(i) % request.width,
                           request.y + static_cast<int>(i) / request.width);
        return traced.distance[i] *
               glm::normalize(shared::faceDirection(
                   request.face, (at + 0.5F) / static_cast<float>(request.faceSize)));
    };
    const auto differ = [&](std::size_t a, std::size_t b) {
        if (traced.distance[a] < 0.0F || traced.distance[b] < 0.0F) {
            return false;
        }
        const float footprint = 2.0F * traced.distance[a] / static_cast<float>(request.faceSize);
        return glm::dot(traced.normal[a], traced.normal[b]) < kSmoothCosine ||
               std::abs(glm::dot(traced.normal[a], pointAt(b) - pointAt(a))) >
                   kSmoothFootprints * footprint ||
               std::abs(traced.visibility[a] - traced.visibility[b]) > kSmoothVisibility;
    };
    const auto width = static_cast<std::size_t>(request.width);
    for (std::size_t i = 0; i < traced.distance.size(); ++i) {
        const bool right = i % width + 1 < width;
        const bool above = i + width < traced.distance.size();
        if ((right && differ(i, i + 1)) || (above && differ(i, i + width))) {
            return true;
        }
    }
    return false;
}

} // namespace aolib
