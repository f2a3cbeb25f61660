#include "content/DefaultCameras.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace aolib {
namespace {

struct KnownView {
    const char* name;
    glm::vec3 eye;
    glm::vec3 target;
    float fovyDeg;
};

/// A model that was looked at. The size tells it from another one that has its name.
struct KnownModel {
    std::string_view stem;
    float diagonal; ///< world units
    std::array<KnownView, 2> views;
};

constexpr float sizeTolerance = 0.01F; ///< of the diagonal

constexpr std::array<KnownModel, 8> knownModels{{
    {"bunny",
     3.2152F,
     {{{"front", {1.5F, 0.6F, 3.0F}, {0.0F, 0.0F, 0.0F}, 40.0F},
       {"back", {-2.7F, 0.5F, -1.9F}, {0.0F, 0.0F, 0.0F}, 40.0F}}}},
    {"cloister",
     54.8495F,
     {{{"court", {12.0F, 2.0F, 8.0F}, {-9.0F, 2.5F, -6.0F}, 62.0F},
       {"gallery", {-17.0F, 6.3F, 8.0F}, {6.0F, 1.0F, -4.0F}, 62.0F}}}},
    {"delft",
     618.5616F,
     {{{"quarter", {60.0F, 40.0F, 120.0F}, {-5.0F, 0.0F, 35.0F}, 50.0F},
       {"yards", {30.0F, 12.0F, 62.0F}, {-20.0F, 2.0F, -15.0F}, 60.0F}}}},
    {"zdm2",
     103.9419F,
     {{{"street", {17.9F, 1.7F, 14.6F}, {5.0F, 2.5F, 7.1F}, 65.0F},
       {"court", {-18.5F, 3.2F, 17.0F}, {-5.5F, 3.9F, 9.5F}, 65.0F}}}},
    {"franka_panda",
     1.0076F,
     {{{"front", {0.95F, 0.75F, 1.05F}, {0.05F, 0.38F, 0.0F}, 38.0F},
       {"low", {-0.85F, 0.25F, 1.1F}, {0.05F, 0.4F, 0.0F}, 40.0F}}}},
    {"sponza_ivy",
     18.6593F,
     {{{"whole", {-5.0F, 9.0F, 13.0F}, {-7.0F, 10.8F, 0.0F}, 52.0F},
       {"leaves", {-4.0F, 14.0F, 7.0F}, {-8.0F, 12.0F, 0.0F}, 40.0F}}}},
    {"flight_helmet",
     0.8858F,
     {{{"front right", {0.65F, 0.6F, 0.95F}, {-0.02F, 0.35F, 0.01F}, 36.0F},
       {"front left", {-0.6F, 0.45F, 0.9F}, {-0.02F, 0.36F, 0.01F}, 38.0F}}}},
    {"boombox",
     0.0344F,
     {{{"right", {0.026F, 0.014F, 0.03F}, {0.0F, 0.0F, 0.0F}, 36.0F},
       {"left", {-0.028F, 0.006F, -0.03F}, {0.0F, 0.0F, 0.0F}, 36.0F}}}},
}};

/// Looks at the middle of the box from a direction, from just so far that its corners fit.
NamedCamera framing(const char* name, const Bounds& bounds, const glm::vec3& from) {
    constexpr float fovyDeg = 40.0F;
    constexpr float aspect = 1.6F; ///< pictures are at least so wide
    constexpr float margin = 1.04F;
    const float size = std::max(bounds.diagonal(), 1e-6F);
    const glm::vec3 back = glm::normalize(from);
    const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.0F, 1.0F, 0.0F), back));
    const glm::vec3 up = glm::cross(back, right);
    const float slope = std::tan(0.5F * glm::radians(fovyDeg));
    float distance = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 half = 0.5F * (bounds.max - bounds.min);
        const glm::vec3 p{(corner & 1) != 0 ? half.x : -half.x,
                          (corner & 2) != 0 ? half.y : -half.y,
                          (corner & 4) != 0 ? half.z : -half.z};
        const float needed = std::max(std::abs(glm::dot(p, up)) / slope,
                                      std::abs(glm::dot(p, right)) / (slope * aspect));
        distance = std::max(distance, glm::dot(p, back) + margin * needed);
    }
    distance = std::max(distance, 0.51F * size); // outside the box
    NamedCamera camera;
    camera.name = name;
    camera.target = bounds.center();
    camera.eye = camera.target + distance * back;
    camera.fovyDeg = fovyDeg;
    camera.near = 0.002F * size;
    camera.far = distance + size;
    return camera;
}

NamedCamera placed(const KnownView& view, float diagonal) {
    NamedCamera camera;
    camera.name = view.name;
    camera.eye = view.eye;
    camera.target = view.target;
    camera.fovyDeg = view.fovyDeg;
    camera.near = 0.001F * diagonal;
    camera.far = 1.5F * diagonal + glm::distance(view.eye, view.target);
    return camera;
}

} // namespace

std::vector<NamedCamera> defaultCameras(const Model& model) {
    const Bounds bounds = model.bounds();
    const float diagonal = bounds.diagonal();
    for (const KnownModel& known : knownModels) {
        if (model.name == known.stem &&
            std::abs(diagonal - known.diagonal) < sizeTolerance * known.diagonal) {
            return {placed(known.views[0], diagonal), placed(known.views[1], diagonal)};
        }
    }
    return {framing("front right", bounds, {0.75F, 0.5F, 1.0F}),
            framing("front left, low", bounds, {-0.85F, 0.12F, 0.8F})};
}

} // namespace aolib
