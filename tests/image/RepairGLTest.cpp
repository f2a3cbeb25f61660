// A view at rest becomes the ray-traced picture, edges finer than texels included.
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

class RepairGLTest : public GLTest {
protected:
    /// Draws the view until nothing is left to compute.
    void converge(RenderedScene& scene, const NamedCamera& camera) {
        for (int frame = 0; frame < kMostRepairs; ++frame) {
            const Status status = scene.frame(camera);
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
        const Model model = buildScene(which);
        const NamedCamera camera = cameraOf(which);
        Options options;
        options.estimator = Estimator::RayTraced;
        options.radius = 0.1F * model.bounds().diagonal();
        options.cubeMaps.faceSize = 128;
        const Picture traced =
            traceView(model, camera, kRepairWidth, kRepairHeight, options.radius, 1024);
        const FloatImage truth = visibilityOf(traced);
        using Way = std::pair<float, ProjectionMethod>; // frame budget, projection
        for (const auto& [budget, method] :
             {Way{0.0F, ProjectionMethod::SinglePass}, Way{20.0F, ProjectionMethod::PingPong}}) {
            options.frameBudget = budget;
            options.cubeMaps.projection = method;
            options.rayTraced.repair = false;
            RenderedScene scene(gl, loader, model, options, kRepairWidth, kRepairHeight);
            ASSERT_TRUE(scene.ready());
            scene.ao().setTexelTracer(std::move(*createTexelTracer(2)));
            ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
            EXPECT_EQ(scene.ao().statistics().pixelsTraced, 0U);
            const double without = rmse(scene.visibility(), truth);
            const ByteImage plain = scene.composite();
            options.rayTraced.repair = true;
            ASSERT_TRUE(scene.ao().setOptions(options).ok());
            ASSERT_NO_FATAL_FAILURE(converge(scene, camera));
            EXPECT_GT(scene.ao().statistics().pixelsTraced, 200U);
            EXPECT_GT(without, 0.02) << "else there is nothing to repair";
            EXPECT_LT(rmse(scene.visibility(), truth), 0.012) << "from " << without;
            EXPECT_NE(scene.composite().pixels, plain.pixels) << "the host's picture shows it";
        }
    }
}

AOLIB_FOR_CORE_CONTEXTS(RepairGLTest);

} // namespace

} // namespace aolib::test
