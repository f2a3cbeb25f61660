// Sizes at the ends of what is allowed: viewports and radii.
#include "Figures.h"
#include "HardScenes.h"

namespace aolib {
namespace {

class ExtremesGLTest : public StabilityTest {
protected:
    const std::vector<glm::vec3> cubeMaps_{{0, 3, 7}, {6, 2, 0}};
};

TEST_P(ExtremesGLTest, ViewportsOfOnePixelAcross) {
    const struct {
        int width;
        int height;
    } sizes[] = {{1, 1}, {2, 2}, {1, 1000}, {1000, 1}};
    for (const auto& size : sizes) {
        NamedCamera camera = courtCamera();
        camera.target.y = 1.0F;
        camera.fovyDeg = size.height < size.width ? 0.1F : 60.0F;
        const Shot shot = shoot(court(), options(2.0F), camera, cubeMaps_, size.width, size.height);
        const Error error = errorOf(shot, court(), options(2.0F), 256);
        report(std::to_string(size.width) + " x " + std::to_string(size.height), error.rmse);
    }
}

TEST_P(ExtremesGLTest, RadiiFromFarBelowATexelToFarBeyondTheScene) {
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp}) {
        for (const float radius : {1e-30F, 1e-6F, 1e-3F, 1e-1F, 1e3F, 1e6F, 1e30F}) {
            Options o = options(radius);
            o.falloff = falloff;
            const Shot shot = shoot(court(), o, courtCamera(), cubeMaps_);
            const Error error = errorOf(shot, court(), o);
            char text[64];
            std::snprintf(text, sizeof text, "radius %g falloff %d", double{radius}, int(falloff));
            report(text, error.rmse);
        }
    }
}

AOLIB_FOR_ALL_ESTIMATORS(ExtremesGLTest);

} // namespace
} // namespace aolib
