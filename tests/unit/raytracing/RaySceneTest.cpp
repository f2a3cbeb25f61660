#include "raytracing/RayScene.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TestScenes.h"

namespace aolib {
namespace {

using test::sceneOf;

/// One triangle in the plane z = 2.
TriangleMesh oneTriangle() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
    mesh.indices = {0, 1, 2};
    return mesh;
}

StatusCode codeOf(const TriangleMesh& mesh) {
    return RayScene::create(mesh).status().code();
}

TEST(RayScene, HitTellsWhereAndWhat) {
    const RayScene scene = sceneOf(oneTriangle());
    const auto hit = scene.intersect({1, 2, -1}, {0, 0, 7});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 3.0, 1e-6);
    EXPECT_NEAR(glm::distance(hit->position, glm::dvec3(1, 2, 2)), 0.0, 1e-6);
    EXPECT_EQ(hit->position.z, 2.0);
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(hit->triangle, 0U);
    EXPECT_NEAR(hit->u, 0.25, 1e-6);
    EXPECT_NEAR(hit->v, 0.5, 1e-6);
}

TEST(RayScene, BothSidesAreHit) {
    const RayScene scene = sceneOf(oneTriangle());
    EXPECT_TRUE(scene.intersect({1, 1, 0}, {0, 0, 1}));
    EXPECT_TRUE(scene.intersect({1, 1, 4}, {0, 0, -1}));
    EXPECT_TRUE(scene.occluded({1, 1, 0}, {0, 0, 1}));
    EXPECT_TRUE(scene.occluded({1, 1, 4}, {0, 0, -1}));
    EXPECT_FALSE(scene.occluded({3, 3, 0}, {0, 0, 1}));
    EXPECT_FALSE(scene.occluded({1, 1, 4}, {0, 0, 1}));
}

TEST(RayScene, RangeIsInWorldUnitsWhateverTheDirectionsLength) {
    const RayScene scene = sceneOf(oneTriangle());
    for (const double length : {0.1, 1.0, 50.0}) {
        const glm::dvec3 direction(0, 0, length);
        EXPECT_TRUE(scene.occluded({1, 1, 0}, direction, 0.0, 2.01));
        EXPECT_FALSE(scene.occluded({1, 1, 0}, direction, 0.0, 1.99));
        EXPECT_TRUE(scene.occluded({1, 1, 0}, direction, 1.99, 100.0));
        EXPECT_FALSE(scene.occluded({1, 1, 0}, direction, 2.01, 100.0));
        EXPECT_FALSE(scene.intersect({1, 1, 0}, direction, 2.01, 100.0));
        EXPECT_FALSE(scene.occluded({1, 1, 0}, direction, 3.0, 1.0));
    }
}

/// The origin is a million scene sizes away; in single precision the ray would miss or be off.
TEST(RayScene, DistantOriginsKeepTheirAim) {
    const RayScene scene = sceneOf(oneTriangle());
    const glm::dvec3 target(1.0, 2.0, 2.0);
    const glm::dvec3 origin = target + 4e6 * glm::normalize(glm::dvec3(0.3, -0.4, 0.5));
    const auto hit = scene.intersect(origin, target - origin);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::distance(hit->position, target), 0.0, 1e-5);
    EXPECT_NEAR(hit->distance, 4e6, 1e-5);
}

TEST(RayScene, FarFromTheOriginHitsStayExact) {
    const glm::vec3 away(1e5F, -1e5F, 1e5F);
    TriangleMesh mesh = oneTriangle();
    for (glm::vec3& p : mesh.positions) {
        p += away;
    }
    const RayScene scene = sceneOf(mesh);
    const auto hit = scene.intersect(glm::dvec3(1, 2, -1) + glm::dvec3(away), {0, 0, 1});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 3.0, 1e-6);
    EXPECT_NEAR(hit->u, 0.25, 1e-6);
    EXPECT_LT(hit->clearance, 1e-5);
}

TEST(RayScene, TrianglesWithoutAreaAreLeftOut) {
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 1}, {1, 1, 1},
                      {2, 2, 1}, {0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
    mesh.indices = {0, 1, 2, 3, 4, 5, 0, 0, 6, 6, 7, 8};
    const RayScene scene = sceneOf(mesh);
    const auto hit = scene.intersect({1, 1, 0}, {0, 0, 1});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->triangle, 3U);
    EXPECT_NEAR(hit->distance, 2.0, 1e-6);
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(scene.mesh().triangleCount(), 4U);
}

/// Three points on one line, which rounding in the scene's frame spreads into a sliver: without
/// area there is no normal, and so there must be no hit.
TEST(RayScene, RoundingMakesNoSlivers) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, glm::vec3(1.1F), glm::vec3(3.3F), {1003.3F, 4.1F, 507.7F}};
    mesh.indices = {0, 1, 2, 3, 3, 3};
    const RayScene scene = sceneOf(mesh);
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 target(3.3 * std::fmod(0.618 * i, 1.0));
        const glm::dvec3 spread =
            1e-4 * (glm::dvec3(std::fmod(0.755 * i, 1.0), std::fmod(0.57 * i, 1.0), 0.5) - 0.5);
        ASSERT_FALSE(scene.occluded(target + spread + glm::dvec3(1, -2, 1), {-1, 2, -1})) << i;
    }
}

TEST(RayScene, EmptyMeshIsNeverHit) {
    const RayScene scene = sceneOf({});
    EXPECT_FALSE(scene.intersect({0, 0, 0}, {1, 2, 3}));
    EXPECT_FALSE(scene.occluded({0, 0, 0}, {1, 2, 3}));
}

TEST(RayScene, OnlyTrianglesWithoutAreaAreLikeNone) {
    TriangleMesh mesh;
    mesh.positions = {{1, 1, 1}};
    mesh.indices = {0, 0, 0};
    EXPECT_FALSE(sceneOf(mesh).occluded({0, 0, 0}, {1, 1, 1}));
}

TEST(RayScene, BadMeshesAreRefused) {
    TriangleMesh mesh = oneTriangle();
    mesh.indices.push_back(0);
    EXPECT_EQ(codeOf(mesh), StatusCode::IncompletePrimitive);
    mesh = oneTriangle();
    mesh.indices[1] = 3;
    EXPECT_EQ(codeOf(mesh), StatusCode::InvalidIndex);
    EXPECT_EQ(RayScene::create(mesh).status().message(), "index 1 is 3 of only 3 vertices");
    mesh = oneTriangle();
    mesh.positions[2].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(codeOf(mesh), StatusCode::InvalidPosition);
    mesh = oneTriangle();
    mesh.normals.resize(2);
    EXPECT_EQ(codeOf(mesh), StatusCode::InvalidNormal);
    mesh.normals.resize(3, glm::vec3(std::numeric_limits<float>::infinity()));
    EXPECT_EQ(codeOf(mesh), StatusCode::InvalidNormal);
}

} // namespace
} // namespace aolib
