#include "backbone/cubemapped/Placement.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace aolib {

namespace {

/// Cube maps are at least this far apart when placed by coverage, as a share of the scene's size.
constexpr float kSpacing = 0.0025F;
/// A cube map's centre stays this far from every surface, as a share of the scene's size.
constexpr float kClearance = 1e-4F;
/// Attempts to get clear: a corner needs one per wall.
constexpr int kNudges = 8;

} // namespace

bool Placement::due(std::optional<float> coverage, float threshold, const glm::vec3& camera,
                    std::span<const glm::vec3> cubeMaps, float sceneSize) {
    if (cubeMaps.empty()) {
        return true;
    }
    if (!coverage || *coverage >= threshold) {
        return false;
    }
    return std::none_of(cubeMaps.begin(), cubeMaps.end(), [&](const glm::vec3& position) {
        return glm::distance(position, camera) < kSpacing * sceneSize;
    });
}

glm::vec3 Placement::freePosition(const Scene& scene, const glm::vec3& wanted) {
    const float needed = kClearance * scene.bounds().diagonal();
    glm::vec3 position = wanted;
    for (int i = 0; i < kNudges; ++i) {
        const Scene::Clearance clearance = scene.clearance(position);
        if (clearance.distance >= needed) {
            break;
        }
        position += clearance.away * (1.01F * needed - clearance.distance);
    }
    return position;
}

} // namespace aolib
