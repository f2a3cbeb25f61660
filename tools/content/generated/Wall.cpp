/// A floor y = 0 and the wall x = 0 of height 1, long enough to count as endless: at distance d
/// from it the floor's occlusion is (1 - d / sqrt(d^2 + 1)) / 2.
#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {

Model buildWall() {
    constexpr float reach = 8.0F;
    constexpr float halfLength = 200.0F;
    SolidBuilder builder;
    builder.quad({-reach, 0, halfLength}, {reach, 0, halfLength}, {reach, 0, -halfLength},
                 {-reach, 0, -halfLength});
    Model model{"wall", {builder.finish("floor", {0.72F, 0.7F, 0.66F})}};
    builder.quad({0, 0, halfLength}, {0, 0, -halfLength}, {0, 1, -halfLength}, {0, 1, halfLength});
    model.meshes.push_back(builder.finish("wall", {0.75F, 0.62F, 0.5F}));
    model.meshes.back().doubleSided = true;
    return model;
}

std::vector<NamedCamera> wallCameras() {
    return {{"oblique", {5.0F, 2.2F, 4.0F}, {0.2F, 0.3F, -1}, {0, 1, 0}, 45.0F, 0.05F, 500.0F},
            {"along", {1.2F, 1.5F, 6.0F}, {0.6F, 0.2F, 0}, {0, 1, 0}, 50.0F, 0.05F, 500.0F}};
}

} // namespace aolib
