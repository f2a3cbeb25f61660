#include <numeric>
#include <string>

#include <gtest/gtest.h>

#include "BakeScenes.h"
#include "bake/maps/Facets.h"

namespace aolib::bake::test {

namespace {

/// The floor with a roof just above the part of it where x < `edge`.
BakeScene floorHalfUnderARoof(float edge) {
    BakeScene scene = sceneOf(unitFloor(1));
    UvMesh roof;
    addUvQuad(roof, {edge - 4.0F, 0.01F, 4.0F}, {4, 0, 0}, {0, 0, -9}, 1);
    scene.surfaces.push_back(surfaceOf(roof, -1));
    return scene;
}

BakedMap mapOf(const BakeScene& scene, int size, int texelSamples) {
    RayOptions rays;
    rays.rays = 1024;
    auto baker = createRayBaker(scene, rays);
    EXPECT_TRUE(baker.ok());
    MapOptions options;
    options.width = options.height = size;
    options.texelSamples = texelSamples;
    auto maps = (*baker)->bakeMaps(options, {});
    EXPECT_TRUE(maps.ok());
    return maps->front();
}

TEST(TexelSamplesTest, ATexelHasTheMeanOverItsArea) {
    const BakeScene scene = floorHalfUnderARoof(0.3F);
    const BakedMap fine = mapOf(scene, 32, 1);
    const double mean =
        std::accumulate(fine.visibility.begin(), fine.visibility.end(), 0.0) / (32.0 * 32.0);
    // Of sixteen places in 2 x 2 texels each column stands for an eighth.
    const BakedMap coarse = mapOf(scene, 2, 16);
    const double of16 =
        std::accumulate(coarse.visibility.begin(), coarse.visibility.end(), 0.0) / 4.0;
    EXPECT_NEAR(of16, mean, 0.05);
    const BakedMap centre = mapOf(scene, 1, 1);
    EXPECT_GT(centre.visibility[0], mean + 0.2) << "the centre lies in the open";
}

TEST(TexelSamplesTest, PlacesBesideTheChartAreNotLookedAt) {
    // The border goes through texel 1 of 4, whose centre lies in the open chart.
    const BakedMap map = mapOf(openBesideClosedChart(), 4, 16);
    for (std::size_t y = 0; y < 4; ++y) {
        EXPECT_GT(map.visibility[y * 4 + 1], 0.95F);
        EXPECT_LT(map.visibility[y * 4 + 2], 0.05F);
    }
}

TEST(TexelSamplesTest, WantedTexelsHaveTheirValuesAndTheOthersNone) {
    RayOptions rays;
    rays.rays = 64;
    auto baker = createRayBaker(floorHalfUnderARoof(0.3F), rays);
    ASSERT_TRUE(baker.ok());
    MapOptions options;
    options.width = options.height = 8;
    options.padding = 0;
    options.fill = false;
    const auto all = (*baker)->bakeMaps(options, {});
    ASSERT_TRUE(all.ok());
    options.wanted.assign(64, 0);
    options.wanted[9] = options.wanted[30] = 1;
    const auto some = (*baker)->bakeMaps(options, {});
    ASSERT_TRUE(some.ok());
    for (std::size_t i = 0; i < 64; ++i) {
        const float expected = options.wanted[i] != 0 ? all->front().visibility[i] : -1.0F;
        EXPECT_EQ(some->front().visibility[i], expected) << i;
        EXPECT_EQ(some->front().kind[i], all->front().kind[i]);
    }
    options.wanted.pop_back();
    const auto wrong = (*baker)->bakeMaps(options, {});
    EXPECT_EQ(wrong.status().code(), StatusCode::InvalidOption);
    EXPECT_NE(wrong.status().message().find("63 texels"), std::string::npos);
}

TEST(FacetsTest, CreasesAndChartsPartThemAndSharedVerticesDoNot) {
    UvMesh mesh;
    addUvQuad(mesh, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 2,
              {{0.0F, 0.0F}, {0.5F, 0.5F}}); // 9 vertices
    addUvQuad(mesh, {1, 0, 0}, {1, 0, 0}, {0, 0, -1}, 1, {{0.5F, 0.0F}, {1.0F, 0.5F}}); // goes on
    addUvQuad(mesh, {2, 0, 0}, {0, 1, 0}, {0, 0, -1}, 1, {{1.0F, 0.0F}, {0.6F, 0.5F}}); // upright
    addUvQuad(mesh, {1, 0, 0}, {1, 0, 0}, {0, 0, -1}, 1, {{0.5F, 0.6F}, {1.0F, 1.0F}}); // elsewhere
    const BakeScene scene = sceneOf(mesh);
    const Facets facets(scene);
    const float first = facets.ofVertex(0, 0);
    EXPECT_GT(first, 0.0F);
    EXPECT_EQ(facets.ofVertex(0, 8), first);
    EXPECT_EQ(facets.ofVertex(0, 9), first) << "the same plane, joined at corners";
    EXPECT_NE(facets.ofVertex(0, 13), first) << "a crease";
    EXPECT_NE(facets.ofVertex(0, 17), first) << "another chart";
    EXPECT_NE(facets.ofVertex(0, 17), facets.ofVertex(0, 13));
}

} // namespace

} // namespace aolib::bake::test
