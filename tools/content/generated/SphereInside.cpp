/// A closed sphere of radius 2 that faces inwards: without a falloff nothing inside sees the sky.
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {

Model buildSphereInside() {
    constexpr float radius = 2.0F;
    constexpr int rings = 32;
    Outline profile;
    for (int i = 0; i <= rings; ++i) {
        const float angle = glm::pi<float>() * static_cast<float>(i) / static_cast<float>(rings);
        const bool pole = i == 0 || i == rings;
        profile.emplace_back(pole ? 0.0F : radius * std::sin(angle), radius * std::cos(angle));
    }
    SolidBuilder builder;
    builder.lathe(profile, 64); // from the north pole downwards: the solid is outside
    return {"sphere-inside", {builder.finish("sphere", {0.75F, 0.75F, 0.8F})}};
}

std::vector<NamedCamera> sphereInsideCameras() {
    return {{"centre", {0, 0, 0}, {0, -0.3F, -1}, {0, 1, 0}, 75.0F, 0.02F, 10.0F},
            {"aside", {0.9F, 0.4F, 0.8F}, {-0.6F, -0.6F, -0.9F}, {0, 1, 0}, 70.0F, 0.02F, 10.0F}};
}

} // namespace aolib
