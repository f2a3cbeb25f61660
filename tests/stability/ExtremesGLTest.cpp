// Sizes at the ends of what is allowed: viewports and radii.
#include <array>
#include <cstdio>

#include "Figures.h"
#include "HardScenes.h"

namespace aolib {
namespace {

class ExtremesGLTest : public StabilityTest {
protected:
    const std::vector<glm::vec3> cubeMaps_{{0.1F, 3, 7}, {6, 2.1F, 0.3F}};
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
        EXPECT_LE(error.rmse, forEach(0.11, 0.04, 0.04));
    }
}

TEST_P(ExtremesGLTest, RadiiFromFarBelowATexelToFarBeyondTheScene) {
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp}) {
        for (const float radius : {1e-30F, 1e-6F, 1e-1F, 1e6F, 1e30F}) {
            Options o = options(radius);
            o.falloff = falloff;
            const Shot shot = shoot(court(), o, courtCamera(), cubeMaps_);
            const Error error = errorOf(shot, court(), o);
            std::array<char, 64> text{};
            std::snprintf(text.data(), text.size(), "radius %g %s", double{radius},
                          falloff == Falloff::Step ? "step" : "exp");
            report(text.data(), error.rmse);
            // Most is lost where the radius is a texel or less; the thesis's estimator also takes
            // what is far behind for near.
            EXPECT_LE(error.rmse, radius < 1.0F ? 0.045 : forEach(0.31, 0.05, 0.04)) << radius;
            if (radius < 1e-8F) {
                EXPECT_LE(error.mean, 0.0) << "nothing is that near: it may be darker by noise";
                EXPECT_GE(error.mean, -1e-3);
            }
        }
    }
}

AOLIB_FOR_ALL_ESTIMATORS(ExtremesGLTest);

} // namespace
} // namespace aolib
