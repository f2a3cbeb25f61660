// A view at rest becomes the picture that its pixels tell, edges finer than texels included:
// traced, or from layered intervals about the eye.
#include <chrono>
#include <thread>
#include <utility>

#include <aolib/RayTracing.h>

#include "CoreContexts.h"
#include "RenderedScene.h"
#include "TracedView.h"

namespace aolib::test {

namespace {

constexpr int kRepairWidth = 160;
constexpr int kRepairHeight = 90;
constexpr int kMostRepairs = 4000;

/// A view, what rays tell of it, and options to show it with.
struct TrueView {
    TrueView(const SceneView& which, Estimator estimator)
        : model(buildScene(which)), camera(cameraOf(which)) {
        options.estimator = estimator;
        options.radius = 0.1F * model.bounds().diagonal();
        options.cubeMaps.faceSize = 128;
        truth = visibilityOf(
            traceView(model, camera, kRepairWidth, kRepairHeight, options.radius, 1024));
    }

    Model model;
    NamedCamera camera;
    Options options;
    FloatImage truth;
};

class RepairGLTest : public GLTest {
protected:
    /// Draws the view until nothing is left to compute.
    void converge(RenderedScene& scene, const NamedCamera& camera) {
        for (int frame = 0; frame < kMostRepairs; ++frame) {
            const AoStatus status = scene.frame(camera);
            ASSERT_TRUE(status.ok()) << status.message();
            gl.Finish();
            const Statistics statistics = scene.ao().statistics();
            if (statistics.converged && statistics.cubeMapsProjected > 0) {
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
        }
        FAIL() << "the picture never converged";
    }
};

TEST_P(RepairGLTest, AViewAtRestBecomesTheTracedPicture) {
    for (const SceneView& which : {SceneView{"town", "square"}, SceneView{"room", "corner"}}) {
        SCOPED_TRACE(which.scene);
        auto [model, camera, options, truth] = TrueView(which, Estimator::RayTraced);
        using Way = std::pair<float, ProjectionMethod>; // frame budget, projection
        for (const auto& [budget, method] :
             {Way{0.0F, ProjectionMethod::SinglePass}, Way{20.0F, ProjectionMethod::PingPong}}) {
            options.frameBudget = budget;
            options.cubeMaps.projection = method;
            options.cubeMaps.refineStaticViews = false;
            RenderedScene scene(gl, loader, model, options, kRepairWidth, kRepairHeight);
            ASSERT_TRUE(scene.ready());
            scene.ao().setTexelTracer(std::move(*createTexelTracer(2)));
            ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
            EXPECT_EQ(scene.ao().statistics().pixelsRefined, 0U);
            const double without = rmse(scene.visibility(), truth);
            const ByteImage plain = scene.composite();
            options.cubeMaps.refineStaticViews = true;
            ASSERT_TRUE(scene.ao().setOptions(options).ok());
            ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
            EXPECT_GT(scene.ao().statistics().pixelsRefined, 200U);
            EXPECT_GT(without, 0.02) << "else there is nothing to repair";
            EXPECT_LT(rmse(scene.visibility(), truth), 0.012) << "from " << without;
            EXPECT_NE(scene.composite().pixels, plain.pixels) << "the host's picture shows it";
        }
    }
}

TEST_P(RepairGLTest, WithoutATracerIntervalsAboutTheEyeTellEveryPixel) {
    auto [model, camera, options, truth] =
        TrueView({"town", "square"}, Estimator::LayeredIntervals);
    FloatImage before; // with another budget
    for (const float budget : {20.0F, 0.0F}) {
        options.frameBudget = budget;
        options.cubeMaps.refineStaticViews = false;
        RenderedScene scene(gl, loader, model, options, kRepairWidth, kRepairHeight);
        ASSERT_TRUE(scene.ready());
        ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
        const double without = rmse(scene.visibility(), truth);
        options.cubeMaps.refineStaticViews = true;
        ASSERT_TRUE(scene.ao().setOptions(options).ok());
        ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
        const FloatImage repaired = scene.visibility();
        EXPECT_GT(without, 0.06) << "else there is nothing to repair";
        EXPECT_LT(rmse(repaired, truth), 0.6 * without);
        ASSERT_TRUE(scene.frame(camera).ok());
        EXPECT_EQ(scene.visibility().pixels, repaired.pixels) << "frame for frame";
        EXPECT_EQ(scene.ao().statistics().bytesBuilding, 0U);
        if (!before.pixels.empty()) { // sums of slices round as they are added up
            EXPECT_LT(rmse(repaired, before), 1e-5) << "however many frames it took";
        }
        before = repaired;
    }
}

AOLIB_FOR_CORE_CONTEXTS(RepairGLTest);

} // namespace

} // namespace aolib::test
