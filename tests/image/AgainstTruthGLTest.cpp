#include <array>
#include <string>

#include "CoreContexts.h"
#include "RenderedScene.h"
#include "TracedView.h"

namespace aolib::test {

namespace {

/// A view, a radius as a share of the scene's diagonal, and the largest RMSE of W that passes.
struct Bound {
    SceneView view;
    float radius;
    double rmse;
};

// The horizon split against 128 rays a pixel, whose own noise is 0.008 to 0.020; one cube map of
// 512 texels at the eye. Behind each bound: what was measured, on llvmpipe.
const std::array kBounds{
    Bound{{"town", "street"}, 0.10F, 0.40},    // 0.377
    Bound{{"town", "street"}, 0.02F, 0.19},    // 0.180
    Bound{{"town", "aerial"}, 0.10F, 0.32},    // 0.302
    Bound{{"room", "corner"}, 0.10F, 0.22},    // 0.210
    Bound{{"room", "corner"}, 0.02F, 0.125},   // 0.116
    Bound{{"room", "table"}, 0.10F, 0.24},     // 0.227
    Bound{{"cornell", "inside"}, 0.10F, 0.09}, // 0.083
    Bound{{"dome", "outside"}, 0.10F, 0.33},   // 0.309
};
constexpr int kTruthWidth = 240;
constexpr int kTruthHeight = 135;
constexpr int kTruthRays = 128;

/// One cube map shades this share of the pixels seen from its own centre. Measured: 0.993 (dome,
/// whose columns are thinner than a pixel) to 1.
constexpr float kCoverage = 0.99F;

/// What projection and blur may add to the RMSE of the texels they read. Measured: 0.0015 (room),
/// 0.0007 (town).
constexpr double kScreenError = 0.01;

/// A model under one camera: rendered in the test's context, and traced.
class AgainstTruthGLTest : public GLTest {
protected:
    /// One cube map, at the eye, and frames until it is counted.
    void render(RenderedScene& scene, const NamedCamera& camera) {
        ASSERT_TRUE(scene.ready());
        const AoStatus status = scene.settle(camera);
        ASSERT_TRUE(status.ok()) << status.message();
        ASSERT_EQ(scene.ao().cubeMaps().size(), 1U);
        EXPECT_GE(scene.ao().statistics().coverage, kCoverage);
    }
};

std::string nameOf(const Bound& bound) {
    return bound.view.scene + " " + bound.view.camera + ", radius " + std::to_string(bound.radius);
}

Options optionsFor(const Model& model, float radius) {
    Options options;
    options.frameBudget = 0.0F;
    options.estimator = Estimator::HorizonSplit;
    options.radius = radius * model.bounds().diagonal();
    return options;
}

TEST_P(AgainstTruthGLTest, HorizonSplitStaysWithinItsBounds) {
    for (const Bound& bound : kBounds) {
        SCOPED_TRACE(nameOf(bound));
        const Model model = buildScene(bound.view);
        const NamedCamera camera = cameraOf(bound.view);
        const Options options = optionsFor(model, bound.radius);
        RenderedScene scene(gl, loader, model, options, kTruthWidth, kTruthHeight);
        ASSERT_NO_FATAL_FAILURE(render(scene, camera));
        const Picture truth =
            traceView(model, camera, kTruthWidth, kTruthHeight, options.radius, kTruthRays);
        EXPECT_LE(rmse(scene.visibility(), visibilityOf(truth)), bound.rmse);
    }
}

TEST_P(AgainstTruthGLTest, ScreenAddsLittleToWhatTheTexelsHold) {
    // At a size at which the blur's seven pixels are small; few rays, for both sides share them.
    constexpr int width = 960;
    constexpr int height = 540;
    constexpr int rays = 32;
    const std::array views{SceneView{"room", "corner"}, SceneView{"town", "aerial"}};
    for (const SceneView& view : views) {
        SCOPED_TRACE(view.scene);
        const Model model = buildScene(view);
        const NamedCamera camera = cameraOf(view);
        const Options options = optionsFor(model, 0.02F);
        RenderedScene scene(gl, loader, model, options, width, height);
        ASSERT_NO_FATAL_FAILURE(render(scene, camera));
        const Result<CubeMapImage> cubeMap =
            scene.ao().readCubeMap(scene.ao().cubeMaps().front().id);
        ASSERT_TRUE(cubeMap.ok()) << cubeMap.status().message();
        const Picture truth = traceView(model, camera, width, height, options.radius, rays);
        const FloatImage reference = visibilityOf(truth);
        const FloatImage texels = texelsAt(*cubeMap, truth);
        // Most pixels' surfaces are in the cube map; at edges a texel may show what is beside.
        EXPECT_GT(shareOfSurface(texels, reference), 0.97);
        EXPECT_LE(rmse(scene.visibility(), reference), rmse(texels, reference) + kScreenError);
    }
}

AOLIB_FOR_CORE_CONTEXTS(AgainstTruthGLTest);

} // namespace

} // namespace aolib::test
