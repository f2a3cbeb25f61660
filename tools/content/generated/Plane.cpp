/// A lone plane: visibility is 1 everywhere.
#include "content/generated/GeneratedScenes.h"
#include "content/generated/SolidBuilder.h"

namespace aolib {

Model buildPlane() {
    SolidBuilder builder;
    constexpr float half = 10.0F;
    builder.quad({-half, 0.0F, half}, {half, 0.0F, half}, {half, 0.0F, -half},
                 {-half, 0.0F, -half});
    return {"plane", {builder.finish("plane", {0.8F, 0.8F, 0.78F})}};
}

std::vector<NamedCamera> planeCameras() {
    return {{"oblique", {0, 3, 9}, {0, 0, 0}, {0, 1, 0}, 45.0F, 0.1F, 60.0F},
            {"above", {0, 8, 0.1F}, {0, 0, 0}, {0, 0, -1}, 60.0F, 0.1F, 60.0F}};
}

} // namespace aolib
