#include "bench/CubeMapPositions.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace aolib::bench {

namespace {

constexpr int kAcross = 3;
/// Where the eye sees nothing: the distance of what it would see, as a share of the diagonal.
constexpr double kSkyShare = 0.25;

} // namespace

std::vector<glm::vec3> cubeMapPositions(const OpenedScene& scene, const NamedCamera& camera,
                                        const PictureSize& size, int count) {
    std::vector<glm::vec3> positions;
    const double aspect = double(size.width) / double(size.height);
    const glm::dvec3 eye(camera.eye);
    for (int i = 0; i < count; ++i) {
        if (i == 0) {
            positions.push_back(camera.eye);
            continue;
        }
        const int cell = (i - 1) % (kAcross * kAcross);
        const int turn = (i - 1) / (kAcross * kAcross);
        const double x = (double(cell % kAcross) + 0.5) / double(kAcross);
        const double y = (double(cell / kAcross) + 0.5) / double(kAcross);
        const Look look = lookThrough(scene.rays, camera, aspect, x, y);
        const glm::dvec3 seen =
            look.hit ? look.hit->position : eye + kSkyShare * scene.diagonal * look.direction;
        positions.emplace_back(eye + std::ldexp(0.5, -turn) * (seen - eye));
    }
    return positions;
}

} // namespace aolib::bench
