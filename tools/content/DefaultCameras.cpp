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

constexpr std::array<KnownModel, 1> knownModels{{
    {"bunny", 3.2F, {{{"front", {1.6F, 0.9F, 2.9F}, {0.0F, -0.1F, 0.0F}, 40.0F},
      {"back, low", {-2.4F, -0.3F, -1.6F}, {0.0F, -0.1F, 0.0F}, 40.0F}}}},
}};

NamedCamera framing(const char* name, const Bounds& bounds, const glm::vec3& from) {
    constexpr float fovyDeg = 40.0F;
    const float radius = std::max(0.5F * bounds.diagonal(), 1e-6F);
    const float distance = 0.92F * radius / std::sin(0.5F * glm::radians(fovyDeg));
    NamedCamera camera;
    camera.name = name;
    camera.target = bounds.center();
    camera.eye = camera.target + distance * glm::normalize(from);
    camera.fovyDeg = fovyDeg;
    camera.near = 0.1F * radius;
    camera.far = distance + 2.0F * radius;
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
