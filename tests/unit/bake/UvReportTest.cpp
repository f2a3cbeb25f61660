#include <aolib/bake/UvReport.h>

#include <limits>

#include <gtest/gtest.h>

#include "BakeScenes.h"

namespace aolib::bake::test {

namespace {

TEST(UvReportTest, GoodUvsHaveNoFaults) {
    for (const std::string& name : uvShapeNames()) {
        const UvReport report = checkUvs(sceneOf(uvShape(name)), 0, 512, 512);
        EXPECT_TRUE(report.good()) << name << ": " << report.sentence();
        EXPECT_EQ(report.unusable(), 0U) << name << ": " << report.sentence();
        EXPECT_EQ(report.overlappingTexels, 0U) << name;
        EXPECT_GT(report.coveredTexels, 80000U) << name;
    }
}

TEST(UvReportTest, CoveredTexelsAreThoseWhoseCentresLieInside) {
    UvMesh mesh;
    addUvQuad(mesh, {}, {1, 0, 0}, {0, 1, 0}, 3, {{0.25F, 0.25F}, {0.75F, 0.5F}});
    const UvReport report = checkUvs(sceneOf(mesh), 0, 64, 64);
    EXPECT_EQ(report.coveredTexels, 32U * 16U);
    EXPECT_EQ(report.triangles, 18U);
}

TEST(UvReportTest, OverlapIsTheShareOfSharedTexels) {
    UvMesh mesh;
    addUvQuad(mesh, {}, {1, 0, 0}, {0, 1, 0}, 2, {{0.0F, 0.0F}, {0.5F, 1.0F}});
    addUvQuad(mesh, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, 2, {{0.25F, 0.0F}, {0.75F, 1.0F}});
    const UvReport report = checkUvs(sceneOf(mesh), 0, 64, 64);
    EXPECT_EQ(report.coveredTexels, 48U * 64U);
    EXPECT_EQ(report.overlappingTexels, 16U * 64U);
    EXPECT_NEAR(report.overlap(), 1.0 / 3.0, 1e-9);
    EXPECT_FALSE(report.good());
    EXPECT_NE(report.sentence().find("33% of them by more than one"), std::string::npos)
        << report.sentence();
}

TEST(UvReportTest, EachFaultIsCountedOnce) {
    BakeScene scene = sceneOf(unitFloor(4));
    std::vector<glm::vec2>& uvs = scene.surfaces[0].uvs;
    const std::vector<std::uint32_t>& indices = scene.surfaces[0].indices;
    // Corners of the grid: the first belongs to two triangles, the last to two others.
    uvs[indices.front()].x = std::numeric_limits<float>::quiet_NaN();
    uvs.back() = {1.5F, 1.0F};
    scene.surfaces.push_back(surfaceOf(unitFloor(1)));
    scene.surfaces[1].uvs.clear();
    scene.surfaces.push_back(surfaceOf(unitFloor(1)));
    scene.surfaces[2].uvs.assign(scene.surfaces[2].uvs.size(), glm::vec2(0.5F));
    scene.surfaces.push_back(surfaceOf(unitFloor(1), 1));
    const UvReport report = checkUvs(scene, 0, 32, 32);
    EXPECT_EQ(report.triangles, 36U);
    EXPECT_EQ(report.notFinite, 2U);
    EXPECT_EQ(report.outside, 2U);
    EXPECT_EQ(report.missing, 2U);
    EXPECT_EQ(report.collapsed, 2U);
    EXPECT_EQ(report.sentence().rfind("of 36 triangles 2 have no UVs, 2 have UVs that are not "
                                      "finite, 2 have UVs outside [0,1], 2 have no area in the map",
                                      0),
              0U)
        << report.sentence();
}

} // namespace

} // namespace aolib::bake::test
