#include "bench/SurfaceElements.h"

#include <cmath>

#include <gtest/gtest.h>

#include "bench/OpenedScene.h"
#include "reference/ClosedForms.h"

namespace aolib::bench {
namespace {

SurfaceElements computed(const OpenedScene& scene, double radius) {
    SurfaceElements::Settings settings;
    settings.radius = radius;
    settings.elements = 20000;
    return SurfaceElements(scene.rays.mesh(), settings);
}

/// W below a point, as a receiver that looks up sees it.
float below(const SurfaceElements& elements, const OpenedScene& scene, const glm::dvec3& from) {
    const std::optional<Hit> hit = scene.rays.intersect(from, {0.0, -1.0, 0.0});
    EXPECT_TRUE(hit);
    return hit ? elements.visibility(hit->triangle, hit->u, hit->v, {0.0F, 1.0F, 0.0F}) : -1.0F;
}

TEST(SurfaceElements, LeaveALonePlaneOpen) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"plane", SceneKind::Generated, false});
    ASSERT_TRUE(scene);
    const SurfaceElements elements = computed(*scene, 0.1 * scene->diagonal);
    EXPECT_GT(elements.count(), 1000U);
    EXPECT_NEAR(below(elements, *scene, {0.1, 1.0, 0.2}), 1.0F, 1e-4F);
}

/// The closed form is matched within what discs in place of a quad cost: a tenth.
TEST(SurfaceElements, DarkenAFloorBelowADisc) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"disc", SceneKind::Generated, false});
    ASSERT_TRUE(scene);
    const SurfaceElements elements = computed(*scene, 10.0);
    EXPECT_NEAR(below(elements, *scene, {0.0, 0.5, 0.0}), 0.5F, 0.1F);
    EXPECT_GT(below(elements, *scene, {4.0, 0.5, 0.0}), 0.95F);
}

TEST(SurfaceElements, DoNotReachBeyondTheRadius) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"disc", SceneKind::Generated, false});
    ASSERT_TRUE(scene);
    const SurfaceElements elements = computed(*scene, 0.9); // the disc lies at a height of 1
    EXPECT_NEAR(below(elements, *scene, {0.0, 0.5, 0.0}), 1.0F, 1e-4F);
}

TEST(SurfaceElements, CloseASphereFromInside) {
    const Result<OpenedScene, LoadError> scene =
        openBenchScene({"sphere-inside", SceneKind::Generated, false});
    ASSERT_TRUE(scene);
    const SurfaceElements elements = computed(*scene, 2.0 * scene->diagonal);
    const glm::dvec3 center(scene->model.bounds().center());
    EXPECT_LT(below(elements, *scene, center), 0.25F);
}

} // namespace
} // namespace aolib::bench
