// Rays about the normals of meshes, where they have any.
#include "raytracing/ShadingNormal.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "TestScenes.h"
#include "TracedFaces.h"

namespace aolib {
namespace {

using test::errorAgainstTruth;
using test::faceRequest;
using test::sceneOf;
using test::seenCount;
using test::traced;

/// A floor without normals, a ball of few facets with them, some of its vertices without, and a
/// leaf that is lit from both sides.
TriangleMesh smoothClutter() {
    TriangleMesh mesh = test::floorAndWall(3.0);
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0F));
    TriangleMesh ball = test::smoothSphere(1.0, 5, 7);
    std::fill_n(ball.normals.begin() + 14, 7, glm::vec3(0.0F));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : ball.positions) {
        mesh.positions.push_back(p + glm::vec3(1.6F, 0.9F, 0.3F));
    }
    mesh.normals.insert(mesh.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const std::uint32_t i : ball.indices) {
        mesh.indices.push_back(first + i);
    }
    test::addQuad(mesh, {2.6, 1.0, -1.5}, {1.2, 0.9, 0.0}, {0.0, 0.4, 3.0});
    const glm::vec3 bent = glm::normalize(glm::vec3(-1.0F, 1.0F, 0.4F));
    mesh.normals.insert(mesh.normals.end(), {bent, -bent, bent, glm::vec3(0.0F)});
    return mesh;
}

TEST(ShadingNormal, ConvergesToTheTruthAboutShadingNormals) {
    const RayScene scene = sceneOf(smoothClutter());
    for (const glm::dvec3& eye : {glm::dvec3(2.8, 2.4, 1.9), glm::dvec3(4.0, 0.6, -0.8)}) {
        for (const Falloff falloff : {Falloff::Step, Falloff::Exp, Falloff::Off}) {
            double worst = 0.0;
            for (int face = 0; face < 6; ++face) {
                const TracedTexels texels =
                    traced(scene, faceRequest(eye, face, 4096, falloff, 1.5));
                if (seenCount(texels) > 0) {
                    worst = std::max(worst, errorAgainstTruth(scene, texels));
                }
            }
            // The truth's own noise is about 0.001.
            EXPECT_LT(worst, 0.003) << static_cast<int>(falloff);
        }
    }
}

/// A lone plane closes the part of a tilted hemisphere that lies below it.
TEST(ShadingNormal, RaysBelowTheTrianglesPlaneAreBlocked) {
    TriangleMesh plane;
    test::addQuad(plane, {-50.0, 0.0, -50.0}, {0.0, 0.0, 100.0}, {100.0, 0.0, 0.0});
    const auto meanUnder = [&](const std::vector<glm::vec3>& normals, int rays, int size) {
        plane.normals = normals;
        const TracedTexels texels =
            traced(sceneOf(plane), faceRequest({0.1, 2.0, 0.2}, 3, rays, Falloff::Off, 1.0, size));
        EXPECT_EQ(texels.normal[0], glm::vec3(0.0F, 1.0F, 0.0F));
        const auto count = static_cast<double>(texels.visibility.size());
        return std::accumulate(texels.visibility.begin(), texels.visibility.end(), 0.0) / count;
    };
    for (const double degrees : {20.0, 45.0, 80.0}) {
        const double angle = degrees * 3.14159265358979 / 180.0;
        const glm::vec3 tilted(glm::dvec3(std::sin(angle), std::cos(angle), 0.0));
        const double open = 0.5 * (1.0 + std::cos(angle));
        EXPECT_NEAR(meanUnder(std::vector(4, tilted), 1024, 8), open, 0.002) << degrees;
        EXPECT_NEAR(meanUnder(std::vector(4, -tilted), 1024, 8), open, 0.002) << "turned round";
        // Packets of one texel, and of fewer rays than lanes.
        EXPECT_NEAR(meanUnder(std::vector(4, tilted), 1024, 1), open, 0.006);
        EXPECT_NEAR(meanUnder(std::vector(4, tilted), 8, 32), open, 0.005);
    }
    EXPECT_EQ(meanUnder(std::vector(4, glm::vec3(0.0F)), 64, 8), 1.0) << "the plane's own";
    EXPECT_EQ(meanUnder(std::vector(4, glm::vec3(0.0F, 3.0F, 0.0F)), 64, 8), 1.0);
}

} // namespace
} // namespace aolib
