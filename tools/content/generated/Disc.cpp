/// A floor and, above its origin, a disc of radius r = 1 at height h = 1: the occlusion of the
/// floor point (0, 0, 0) is r^2 / (r^2 + h^2) = 1/2.
#include <cmath>
#include <cstddef>

#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {

Model buildDisc() {
    constexpr float half = 6.0F;
    SolidBuilder builder;
    builder.quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
    Model model{"disc", {builder.finish("floor", {0.72F, 0.7F, 0.66F})}};
    const Outline rim = regularPolygon(1.0F, 256);
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const glm::vec2& p = rim[i];
        const glm::vec2& q = rim[(i + 1) % rim.size()];
        builder.triangle({0, 1, 0}, {p.x, 1, -p.y}, {q.x, 1, -q.y});
    }
    model.meshes.push_back(builder.finish("disc", {0.45F, 0.58F, 0.68F}));
    model.meshes.back().doubleSided = true;
    return model;
}

std::vector<NamedCamera> discCameras() {
    return {{"oblique", {3.4F, 1.7F, 4.2F}, {0, 0.35F, 0}, {0, 1, 0}, 45.0F, 0.05F, 40.0F},
            {"below", {2.4F, 0.6F, 1.6F}, {0, 0.1F, 0}, {0, 1, 0}, 50.0F, 0.05F, 40.0F}};
}

} // namespace aolib
