#include "backbone/texels/TexelCodes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "shared/cube_faces.h"
#include "shared/distance_code.h"

namespace aolib {

namespace {

/// Texels about those that are measured in which a surface may be that none of them sees.
constexpr float kBetweenTexels = 2.0F;

/// Where on its face the middle of a request's texel lies, 0 to 1.
glm::vec2 texelAt(const TexelRequest& request, std::size_t number) {
    const auto column = static_cast<int>(number) % request.width;
    const auto row = static_cast<int>(number) / request.width;
    return (glm::vec2(request.x + column, request.y + row) + 0.5F) /
           static_cast<float>(request.faceSize);
}

} // namespace

TexelCodes encodeTexels(const TracedTexels& traced, const std::vector<float>& sum, int rays,
                        const glm::vec2& code) {
    TexelCodes codes{std::vector<std::uint8_t>(traced.distance.size(), 255),
                     std::vector<std::uint16_t>(traced.distance.size(), 0)};
    for (std::size_t i = 0; i < traced.distance.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            continue;
        }
        const glm::vec3 direction = shared::faceDirection(0, texelAt(traced.request, i));
        const float along = traced.distance[i] / glm::length(direction);
        const float visibility = std::clamp(sum[i] / static_cast<float>(rays), 0.0F, 1.0F);
        codes.visibility[i] = static_cast<std::uint8_t>(std::lround(255.0F * visibility));
        codes.depth[i] =
            static_cast<std::uint16_t>(std::lround(65535.0F * shared::encodeDistance(along, code)));
    }
    return codes;
}

SeenSurfaces seenSurfaces(const TracedTexels& traced) {
    const TexelRequest& request = traced.request;
    SeenSurfaces seen{{}, 0.0F};
    float reach = 0.0F;
    for (std::size_t i = 0; i < traced.distance.size(); ++i) {
        if (traced.distance[i] < 0.0F) {
            seen.farthest = SeenSurfaces::kInfinite;
            continue;
        }
        const glm::vec3 direction = shared::faceDirection(request.face, texelAt(request, i));
        seen.surfaces.include(request.centre + traced.distance[i] * glm::normalize(direction));
        reach = std::max(reach, traced.distance[i]);
    }
    seen.farthest = std::max(seen.farthest, reach);
    seen.surfaces = seen.surfaces.inflated(2.0F * kBetweenTexels * reach /
                                           static_cast<float>(request.faceSize));
    return seen;
}

} // namespace aolib
