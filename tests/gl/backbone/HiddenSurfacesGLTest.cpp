// What a cube map's centre does not see, but knows of from the layers behind.
#include "ProgressiveTest.h"

namespace aolib {
namespace {

class HiddenSurfacesGLTest : public ProgressiveTest {
protected:
    static constexpr glm::vec3 kCentre{0.0F, 1.0F, 5.0F};

    static Options options() {
        Options o = ProgressiveTest::options(Estimator::LayeredIntervals);
        o.layeredIntervals = {.slices = 8, .steps = 16};
        o.cubeMaps.faceSize = 256;
        o.cubeMaps.refineStaticViews = false;
        return o;
    }
    SmallHost hostOf(const Options& o, const Model& model, const glm::vec3& centre = kCentre) {
        SmallHost host = hostWith(o, model);
        host.lookAt({0.3F, 6, -1.4F}, {0, 0, -0.6F}); // from above: the tops and the floor between
        EXPECT_TRUE(host.ao().addCubeMap(centre).ok());
        EXPECT_GT(converge(host), 0);
        return host;
    }
    /// The same at once: no view has asked for what is hidden.
    SmallHost hostAtOnce(Options o, const Model& model) {
        o.frameBudget = 0.0F;
        return hostOf(o, model);
    }
    static std::size_t bytesKept(SmallHost& host) { return host.ao().statistics().bytesKept; }
};

TEST_P(HiddenSurfacesGLTest, AreShadedWhereAViewShowsThem) {
    SmallHost seen = hostOf(options(), walls(), {0.3F, 5.9F, -1.4F}); // all but at the eye
    SmallHost hidden = hostOf(options(), walls());
    SmallHost without = hostAtOnce(options(), walls());
    const Picture truth = seen.visibility().visibility;
    EXPECT_LT(without.ao().statistics().coverage, 0.75F) << "nothing is hidden";
    EXPECT_GT(hidden.ao().statistics().coverage, 0.92F);
    EXPECT_LT(rmse(truth, hidden.visibility().visibility), 0.06);
    EXPECT_GT(rmse(truth, without.visibility().visibility), 0.1);
    // Behind one wall, and behind both.
    for (const glm::vec3 place : {glm::vec3(0.5F, 0, 0.7F), {-0.5F, 0, -1.7F}}) {
        EXPECT_NEAR(hidden.visibilityAt(place), seen.visibilityAt(place), 0.06F);
        EXPECT_LT(hidden.visibilityAt(place), 0.9F);
    }
}

TEST_P(HiddenSurfacesGLTest, AreTheSameInOnePassAndInMany) {
    Options o = options();
    SmallHost host = hostOf(o, walls());
    ASSERT_TRUE(host.ao().addCubeMap({3, 1, 5}).ok());
    ASSERT_GT(converge(host), 0);
    const Picture single = host.visibility().visibility;
    o.cubeMaps.projection = ProjectionMethod::PingPong;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_LE(largestChange(single, host.visibility().visibility), 1.0 / 255.0);
}

TEST_P(HiddenSurfacesGLTest, FollowWhatMovesOutOfSight) {
    Options o = options();
    o.radius = 0.4F; // so that what is about the box is out of viewpoint, too
    Model box;
    addBox(box, {-0.3F, 0, -0.3F}, {0.1F, 0.3F, 0.1F}); // between the walls
    const ModelMesh& mesh = box.meshes.front();
    Model model = walls();
    model.meshes.push_back(mesh);
    SmallHost whole = hostOf(o, model);
    const glm::vec3 beside(0.17F, 0, -0.1F);
    for (const bool captureHeld : {false, true}) {
        SmallHost host = hostOf(o, walls());
        if (captureHeld) { // by a view of floor that no view has shown yet
            host.lookAt({5, 3, 6}, {6, 0, 6.5F});
            ASSERT_GT(converge(host), 0);
            ASSERT_GT(host.ao().statistics().bytesBuilding, 0U) << "nothing is held";
            host.lookAt({0.3F, 6, -1.4F}, {0, 0, -0.6F});
            ASSERT_TRUE(host.frame().ok());
        }
        const float before = host.visibilityAt(beside);
        ASSERT_TRUE(host.ao().addMesh({mesh.positions, {}, mesh.indices}).ok());
        ASSERT_TRUE(host.frame().ok());
        EXPECT_EQ(host.ao().statistics().cubeMapsBuilt, 0) << "it was seen; this shows nothing";
        ASSERT_GT(converge(host), 0);
        const float after = host.visibilityAt(beside);
        EXPECT_LT(after, before - 0.1F) << captureHeld;
        EXPECT_NEAR(after, whole.visibilityAt(beside), 0.03F) << captureHeld;
    }
}

TEST_P(HiddenSurfacesGLTest, CostNothingWhereNothingIsHiddenOrNobodyLooks) {
    const Options o = options();
    const glm::vec3 eye(0.3F, 6, -1.4F);
    EXPECT_EQ(bytesKept(*std::make_unique<SmallHost>(hostOf(o, walls(), eye))),
              bytesKept(*std::make_unique<SmallHost>(hostAtOnce(o, walls()))));
}

TEST_P(HiddenSurfacesGLTest, GoWithoutWhereThereIsNoRoom) {
    Options o = options();
    o.cubeMaps.memoryBudget = 6.5F * 3 * 256 * 256 / (1 << 20); // the six faces
    SmallHost host = hostOf(o, walls());
    EXPECT_LT(host.ao().statistics().coverage, 0.75F);
    EXPECT_TRUE(host.ao().statistics().converged);
    o.cubeMaps.memoryBudget = 64.0F;
    ASSERT_TRUE(host.ao().setOptions(o).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_GT(host.ao().statistics().coverage, 0.92F) << "now there is";
}

AOLIB_FOR_ALL_CONTEXTS(HiddenSurfacesGLTest);

} // namespace
} // namespace aolib
