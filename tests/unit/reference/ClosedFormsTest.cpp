#include "reference/ClosedForms.h"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "TestScenes.h"

namespace aolib {
namespace {

using test::sceneOf;
using test::tracing;
using test::visibilityAt;

const glm::dvec3 up(0.0, 1.0, 0.0);

/// Four standard errors, and what the tessellation and the float accumulate at most.
void expectOcclusion(const VisibilityEstimate& estimate, double occlusion) {
    const double bound = 4.0 * std::sqrt(estimate.variance) + 2e-5;
    EXPECT_NEAR(1.0 - estimate.visibility, occlusion, bound);
    EXPECT_LT(bound, 0.005) << "the bound says nothing";
}

/// Midpoint rule over mu = cos(theta) in [low, high] of `2 mu w(L(mu))`.
template <typename Weight>
double quadrature(double low, double high, Weight weight) {
    constexpr int steps = 100000;
    const double step = (high - low) / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double mu = low + (i + 0.5) * step;
        sum += 2.0 * mu * weight(mu) * step;
    }
    return sum;
}

TEST(ClosedForms, KnownValues) {
    EXPECT_DOUBLE_EQ(wallOcclusion(0.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(wallOcclusion(3.0, 4.0), 0.1);
    EXPECT_NEAR(wallOcclusion(1e9, 1.0), 0.5, 1e-9);
    EXPECT_DOUBLE_EQ(discOcclusion(1.0, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(discOcclusionStep(1.0, 1.0, 0.5), 0.0);
    EXPECT_DOUBLE_EQ(discOcclusionStep(1.0, 1.0, 5.0), 0.5);
    EXPECT_DOUBLE_EQ(discOcclusionStep(10.0, 3.0, 5.0), 16.0 / 25.0);
    EXPECT_DOUBLE_EQ(insideSphereOcclusionStep(1.0, 3.0), 1.0);
    EXPECT_DOUBLE_EQ(insideSphereOcclusionStep(1.0, 1.0), 0.25);
}

TEST(ClosedForms, SphereWithExpFalloffAgreesWithQuadrature) {
    for (const double radius : {0.1, 0.7, 4.0}) {
        const double integral =
            quadrature(0.0, 1.0, [&](double mu) { return std::exp(-2.0 * mu / radius); });
        EXPECT_NEAR(insideSphereOcclusionExp(1.0, radius), integral, 1e-8) << radius;
    }
}

TEST(ClosedForms, TracedWall) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    for (const double distance : {0.25, 1.0, 4.0}) {
        SCOPED_TRACE(distance);
        const Receiver receiver{{distance, 0.0, 0.0}, up};
        expectOcclusion(visibilityAt(scene, receiver, tracing(65536)),
                        wallOcclusion(2.0, distance));
    }
}

TEST(ClosedForms, TracedDiscFromBothSides) {
    for (const bool facingUp : {false, true}) {
        SCOPED_TRACE(facingUp);
        const RayScene scene = sceneOf(test::disc(1.5, 2.0, facingUp));
        expectOcclusion(visibilityAt(scene, {{0.0, 0.0, 0.0}, up}, tracing(65536)),
                        discOcclusion(1.5, 2.0));
    }
}

TEST(ClosedForms, TracedDiscSeesOnlyTheHemisphereAboveTheNormal) {
    const RayScene scene = sceneOf(test::disc(1.5, 2.0));
    EXPECT_EQ(visibilityAt(scene, {{0.0, 0.0, 0.0}, -up}, tracing(1024)).visibility, 1.0);
}

TEST(ClosedForms, TracedDiscWithStepFalloff) {
    const RayScene scene = sceneOf(test::disc(3.0, 1.0));
    for (const double radius : {0.9, 1.25, 2.0, 50.0}) {
        SCOPED_TRACE(radius);
        expectOcclusion(
            visibilityAt(scene, {{0.0, 0.0, 0.0}, up}, tracing(65536, Falloff::Step, radius)),
            discOcclusionStep(3.0, 1.0, radius));
    }
}

TEST(ClosedForms, TracedDiscWithExpFalloff) {
    const RayScene scene = sceneOf(test::disc(3.0, 1.0));
    for (const double radius : {0.3, 1.0, 10.0}) {
        SCOPED_TRACE(radius);
        const double integral = quadrature(
            1.0 / std::sqrt(10.0), 1.0, [&](double mu) { return std::exp(-1.0 / (mu * radius)); });
        expectOcclusion(
            visibilityAt(scene, {{0.0, 0.0, 0.0}, up}, tracing(65536, Falloff::Exp, radius)),
            integral);
    }
}

/// The receiver lies on a facet, a sagitta of 2e-5 of the radius inside the sphere.
TEST(ClosedForms, TracedSphereFromInside) {
    const RayScene scene = sceneOf(test::sphere(2.0));
    const auto facet = scene.intersect({0.0, 0.0, 0.0}, {0.3, 0.5, 0.2});
    ASSERT_TRUE(facet);
    const Receiver receiver{facet->position, -facet->normal, facet->clearance};
    EXPECT_EQ(visibilityAt(scene, receiver, tracing(4096)).visibility, 0.0);
    expectOcclusion(visibilityAt(scene, receiver, tracing(65536, Falloff::Exp, 1.5)),
                    insideSphereOcclusionExp(2.0, 1.5));
    expectOcclusion(visibilityAt(scene, receiver, tracing(65536, Falloff::Step, 1.5)),
                    insideSphereOcclusionStep(2.0, 1.5));
}

TEST(ClosedForms, TracedClosedRoomIsDark) {
    const RayScene scene = sceneOf(test::box());
    for (const glm::dvec3& p : {glm::dvec3(0.3, -1.0, 0.1), glm::dvec3(0.999, -1.0, 0.999)}) {
        EXPECT_EQ(1.0 - visibilityAt(scene, {p, up}, tracing(4096)).visibility,
                  closedRoomOcclusion());
    }
}

/// Tilted planes, small and large, near and far: not one ray may meet the plane it starts on.
TEST(ClosedForms, TracedLonePlaneIsOpen) {
    for (const double scale : {1e-4, 1.0, 1e6}) {
        for (const double away : {0.0, 1e5}) {
            SCOPED_TRACE(std::to_string(scale) + ", " + std::to_string(away));
            const glm::dvec3 a = scale * glm::dvec3(1.0, 0.37, -0.21);
            const glm::dvec3 b = scale * glm::dvec3(0.11, -0.53, 0.9);
            const glm::dvec3 corner = scale * glm::dvec3(away, -away, away);
            TriangleMesh mesh;
            test::addQuad(mesh, corner, a, b);
            const RayScene scene = sceneOf(mesh);
            const glm::dvec3 p0(mesh.positions[0]);
            const glm::dvec3 p1(mesh.positions[1]);
            const glm::dvec3 p2(mesh.positions[2]);
            for (int i = 1; i < 20; ++i) {
                const double u = 0.05 * i;
                const glm::dvec3 p = p0 + u * (p1 - p0) + 0.5 * (1.0 - u) * (p2 - p0);
                const glm::dvec3 n = glm::cross(p1 - p0, p2 - p0);
                // Rounded to float, as a baker's or a renderer's positions are.
                const Receiver receiver{glm::dvec3(glm::vec3(p)), n};
                EXPECT_EQ(1.0 - visibilityAt(scene, receiver, tracing(512)).visibility,
                          lonePlaneOcclusion());
            }
        }
    }
}

} // namespace
} // namespace aolib
