#include "backbone/cubemaps/Placement.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace aolib {

namespace {

/// Cube maps are at least this far apart when placed by coverage, as a share of the scene's size.
constexpr float kSpacing = 0.0025F;
/// A cube map's centre stays this far from every surface, as a share of the scene's size.
constexpr float kClearance = 1e-4F;
/// A near plane that cuts off more than this share of a scene's depth shows its inside.
constexpr double kCut = 0.01;
/// Width of texels where the view's first surfaces are, in its pixels.
constexpr double kPixelsPerTexel = 2.0;
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

glm::vec3 Placement::standpoint(const Frame& frame, const Bounds& scene, int faceSize) {
    const HostCamera& camera = frame.camera;
    if (!camera.orthographic() || scene.empty()) {
        return frame.position;
    }
    const glm::dmat3& toWorld = camera.eyeToWorld();
    const glm::dmat4& p = camera.projection();
    const Bounds box = transformed(
        scene, glm::mat4(glm::translate(glm::dmat4(glm::transpose(toWorld)), -camera.eye())));
    // What the view's sides leave of the box, and the plane before which nothing is drawn.
    const glm::dvec2 middle(-p[3][0] / p[0][0], -p[3][1] / p[1][1]);
    const glm::dvec2 half = glm::abs(p[3][3] / glm::dvec2(p[0][0], p[1][1]));
    const glm::dvec2 low = glm::max(glm::dvec2(box.min), middle - half);
    const glm::dvec2 high = glm::min(glm::dvec2(box.max), middle + half);
    const glm::dvec2 centre = glm::clamp(0.5 * (low + high), middle - half, middle + half);
    const double extent = 0.5 * std::max({high.x - low.x, high.y - low.y, 0.0});
    // Texels at a distance d are 2 d / faceSize wide.
    const double pixel = 2.0 * half.y / frame.size.y;
    const double away = std::max(extent, 0.5 * kPixelsPerTexel * faceSize * pixel);
    const double ends[]{(frame.clip.zeroToOne ? 0.0 : -1.0), 1.0};
    const double nearPlane = std::max(((ends[0] * p[3][3]) - p[3][2]) / p[2][2],
                                      ((ends[1] * p[3][3]) - p[3][2]) / p[2][2]);
    const double top = box.max.z; // the view looks along -z
    const bool cut = nearPlane < top - kCut * (double{box.max.z} - double{box.min.z});
    const double z = cut ? nearPlane : top + away;
    return glm::vec3(camera.eye() + toWorld * glm::dvec3(centre, z));
}

glm::vec3 Placement::across(const HostCamera& camera, const glm::vec3& standpoint,
                            const glm::vec3& point) {
    const glm::dvec3 viewer = camera.eyeToWorld()[2];
    return glm::vec3(glm::dvec3(point) +
                     glm::dot(glm::dvec3(standpoint) - glm::dvec3(point), viewer) * viewer);
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
