// Meshes move, change and go: the cube maps that see it are rebuilt, the others are not.
#include "SmallScene.h"

namespace aolib {
namespace {

Options options() {
    Options o = atOnce();
    o.radius = 1.0F;
    o.cubeMaps.faceSize = 64;
    o.cubeMaps.place = false;
    return o;
}

/// Two rooms side by side, a wall between them; a box in the left one.
class SceneEditGLTest : public GLTest {
protected:
    static constexpr float kWall = 0.0F;

    static Model rooms() {
        Model model;
        // The inside of two boxes is what cube maps see; sides are two-sided.
        addBox(model, {-6, 0, -3}, {kWall, 3, 3});
        addBox(model, {kWall, 0, -3}, {6, 3, 3});
        return model;
    }
    static MeshData boxData(const Model& box, const glm::mat4& transform) {
        return {box.meshes[0].positions, {}, box.meshes[0].indices, transform};
    }
    static glm::mat4 at(float x) { return glm::translate(glm::mat4(1.0F), {x, 0, 0}); }
};

TEST_P(SceneEditGLTest, OnlyTheCubeMapsThatSeeAChangeAreRebuilt) {
    SmallHost host(gl, loader, rooms(), options());
    AmbientOcclusion& ao = host.ao();
    Model box;
    addBox(box, {-0.5F, 0.01F, -0.5F}, {0.5F, 1, 0.5F});
    const MeshId id = *ao.addMesh(boxData(box, at(-4)));
    ASSERT_TRUE(ao.addCubeMap({-3, 1.5F, 2}).ok());
    ASSERT_TRUE(ao.addCubeMap({3, 1.5F, 2}).ok());
    host.lookAt({-3, 1.5F, 2.5F}, {-4, 0, 0});
    ASSERT_TRUE(host.frame().ok());
    ASSERT_EQ(ao.statistics().cubeMapsBuilt, 0) << "both were built when they were added";

    const float besideBox = host.visibilityAt({-3.4F, 0.01F, 0.3F});
    ASSERT_TRUE(ao.moveMesh(id, at(-4.5F)).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(ao.statistics().cubeMapsBuilt, 1) << "the right room does not see the box";
    EXPECT_GT(host.visibilityAt({-3.4F, 0.01F, 0.3F}), besideBox) << "the box went away from there";
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(ao.statistics().cubeMapsBuilt, 0) << "nothing changed since";

    ASSERT_TRUE(ao.moveMesh(id, at(4)).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(ao.statistics().cubeMapsBuilt, 2) << "it left one room and entered the other";
    ASSERT_TRUE(ao.replaceMesh(id, boxData(box, at(4.5F))).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(ao.statistics().cubeMapsBuilt, 1);
    ASSERT_TRUE(ao.removeMesh(id).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_EQ(ao.statistics().cubeMapsBuilt, 1);
}

TEST_P(SceneEditGLTest, AFreshSceneAndAnEditedOneAgree) {
    Model box;
    addBox(box, {-0.5F, 0.01F, -0.5F}, {0.5F, 1, 0.5F});
    const auto visibility = [&](bool edited) {
        SmallHost host(gl, loader, rooms(), options());
        const MeshId id = *host.ao().addMesh(boxData(box, at(edited ? -2.0F : -4.0F)));
        EXPECT_TRUE(host.ao().addCubeMap({-3, 1.5F, 2}).ok());
        host.lookAt({-3, 1.5F, 2.5F}, {-4, 0, 0});
        EXPECT_TRUE(host.frame().ok());
        if (edited) {
            EXPECT_TRUE(host.ao().moveMesh(id, at(-4)).ok());
            EXPECT_TRUE(host.frame().ok());
        }
        return host.visibility().visibility;
    };
    EXPECT_EQ(visibility(false), visibility(true));
}

TEST_P(SceneEditGLTest, OptionsThatTheEstimateNeedsRebuild) {
    SmallHost host(gl, loader, rooms(), options());
    ASSERT_TRUE(host.ao().addCubeMap({-3, 1.5F, 2}).ok());
    host.lookAt({-3, 1.5F, 2.5F}, {-4, 0, 0});
    const auto builtAfter = [&](auto&& change) {
        Options o = host.ao().options();
        change(o);
        EXPECT_TRUE(host.ao().setOptions(o).ok());
        EXPECT_TRUE(host.frame().ok());
        return host.ao().statistics().cubeMapsBuilt;
    };
    EXPECT_EQ(builtAfter([](Options&) {}), 0);
    EXPECT_EQ(builtAfter([](Options& o) { o.contrast = 0.5F; }), 0);
    EXPECT_EQ(builtAfter([](Options& o) { o.radius = 0.5F; }), 1);
    EXPECT_EQ(builtAfter([](Options& o) { o.horizonSplit.directions = 4; }), 1);
    EXPECT_EQ(builtAfter([](Options& o) { o.falloff = Falloff::Exp; }), 1);
    EXPECT_EQ(builtAfter([](Options& o) { o.cubeMaps.faceSize = 32; }), 1);
    EXPECT_EQ(host.ao().cubeMaps()[0].faceSize, 32);
}

TEST_P(SceneEditGLTest, AnEmptiedSceneHasNothingLeftToCompute) {
    Options o = options();
    o.estimator = Estimator::LayeredIntervals;
    o.layeredIntervals = {.slices = 1, .steps = 2, .layers = 1};
    SmallHost host(gl, loader, Model(), o);
    Model box;
    addBox(box, {-0.5F, 0.01F, -0.5F}, {0.5F, 1, 0.5F});
    const MeshId id = *host.ao().addMesh(boxData(box, at(0)));
    host.lookAt({0, 2, 3}, {0, 0, 0});
    ASSERT_TRUE(host.ao().addCubeMap({0, 2, 3}).ok());
    ASSERT_TRUE(host.frame().ok());
    ASSERT_FALSE(host.ao().statistics().converged) << "pixels are left for when the view rests";
    ASSERT_TRUE(host.ao().removeMesh(id).ok());
    ASSERT_TRUE(host.frame().ok());
    EXPECT_TRUE(host.ao().statistics().converged);
    EXPECT_EQ(host.ao().statistics().pixelsRefined, 0U);
}

AOLIB_FOR_ALL_CONTEXTS(SceneEditGLTest);

} // namespace
} // namespace aolib
