#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "BakeScenes.h"
#include "reference/ClosedForms.h"

namespace aolib::bake::test {

namespace {

BakedVertices verticesOf(BakeScene scene, const VertexOptions& options, int rays = 1024) {
    RayOptions ray;
    ray.rays = rays;
    auto baker = createRayBaker(std::move(scene), ray);
    EXPECT_TRUE(baker.ok()) << baker.status().message();
    auto vertices = (*baker)->bakeVertices(options, {});
    EXPECT_TRUE(vertices.ok()) << vertices.status().message();
    EXPECT_EQ(vertices->size(), 2U);
    EXPECT_TRUE(vertices->at(1).visibility.empty()) << "an occluder has got values";
    return vertices->front();
}

/// RMSE over the floor of values that are interpolated between the columns of vertices.
double surfaceError(const BakedVertices& vertices, int cells, double height) {
    double sum = 0.0;
    constexpr int samples = 500;
    for (int i = 0; i < samples; ++i) {
        const double x = (i + 0.5) / samples;
        const int column = static_cast<int>(x * cells);
        const double share = x * cells - column;
        // The row in the middle of the floor.
        const auto first = static_cast<std::size_t>((cells / 2) * (cells + 1) + column);
        const double w = (1.0 - share) * double(vertices.visibility[first]) +
                         share * double(vertices.visibility[first + 1]);
        const double error = w - (1.0 - wallOcclusion(height, x));
        sum += error * error;
    }
    return std::sqrt(sum / samples);
}

TEST(VertexTest, SectorsAreOpenWhereNothingStands) {
    RayOptions ray;
    ray.rays = 1024;
    ray.sectors = true;
    // The wall stands at x = 0, which is towards -x, high enough to hide all of that side.
    auto baker = createRayBaker(floorBesideWall(1000.0, 8), ray);
    ASSERT_TRUE(baker.ok());
    const auto vertices = (*baker)->bakeVertices({}, {});
    ASSERT_TRUE(vertices.ok()) << vertices.status().message();
    const BakedVertices& floor = vertices->front();
    ASSERT_EQ(floor.sectors.size(), floor.visibility.size());
    EXPECT_TRUE(vertices->at(1).sectors.empty()) << "it only occludes";
    const OpenSectors& open = floor.sectors[4 * 9 + 4];
    for (std::size_t k = 0; k < open.size(); ++k) {
        const bool above = (k & 2U) != 0;
        const bool right = (k & 1U) != 0; // towards +x
        EXPECT_NEAR(open[k], above ? (right ? 1.0F : 0.0F) : floor.visibility[4 * 9 + 4], 0.01F)
            << k;
    }
    VertexOptions fitted;
    fitted.fit = VertexFit::LeastSquares;
    EXPECT_EQ((*baker)->bakeVertices(fitted, {}).status().code(), StatusCode::MissingCapability);
    EXPECT_TRUE(verticesOf(floorBesideWall(1.0, 2), {}, 4).sectors.empty()) << "not asked for";
}

TEST(VertexTest, DirectValuesAreThoseOfTheVertices) {
    const BakedVertices vertices = verticesOf(floorBesideWall(0.5, 8), {});
    ASSERT_EQ(vertices.visibility.size(), 81U);
    for (int i = 1; i <= 8; ++i) {
        EXPECT_NEAR(double(vertices.visibility[std::size_t(4 * 9 + i)]),
                    1.0 - wallOcclusion(0.5, i / 8.0), 0.012);
    }
}

TEST(VertexTest, MeansOfTrianglesBlurOverTwoCells) {
    VertexOptions options;
    options.fit = VertexFit::TriangleMean;
    const BakedVertices vertices = verticesOf(floorBesideWall(0.5, 16), options);
    EXPECT_LT(surfaceError(vertices, 16, 0.5), 0.02);
    const glm::vec3& leaning = vertices.bentNormal[8 * 17 + 1];
    EXPECT_GT(leaning.x, 0.2F);
    EXPECT_NEAR(glm::length(leaning), 1.0F, 1e-5F);
}

TEST(VertexTest, LeastSquaresFitTheSurfaceBetterThanItsVertices) {
    VertexOptions options;
    const double direct = surfaceError(verticesOf(floorBesideWall(0.3, 4), options), 4, 0.3);
    options.fit = VertexFit::LeastSquares;
    options.density = 64.0F;
    options.smoothness = 0.001F;
    const double fitted = surfaceError(verticesOf(floorBesideWall(0.3, 4), options), 4, 0.3);
    EXPECT_LT(fitted, 0.75 * direct);
}

TEST(VertexTest, SmoothnessDrawsValuesTogether) {
    VertexOptions options;
    options.fit = VertexFit::LeastSquares;
    options.smoothness = 100.0F;
    const BakedVertices vertices = verticesOf(floorBesideWall(0.5, 4), options, 256);
    const auto [least, most] =
        std::minmax_element(vertices.visibility.begin(), vertices.visibility.end());
    EXPECT_LT(*most - *least, 0.1F);
}

TEST(VertexTest, VerticesThatOnlyUvsPartGetOneValue) {
    BakeScene scene = floorBesideWall(0.5);
    scene.surfaces[0] = surfaceOf(uvShape("uv-sphere"));
    scene.surfaces[1].positions[0].x = -0.5F;
    for (const VertexFit fit :
         {VertexFit::Direct, VertexFit::TriangleMean, VertexFit::LeastSquares}) {
        VertexOptions options;
        options.fit = fit;
        const BakedVertices vertices = verticesOf(scene, options, 16);
        for (std::size_t ring = 1; ring < 32; ++ring) { // poles have a vertex per segment
            EXPECT_EQ(vertices.visibility[ring * 65], vertices.visibility[ring * 65 + 64]);
        }
    }
}

TEST(VertexTest, UnusedVerticesAreOpen) {
    BakeScene scene = floorBesideWall(0.5);
    scene.surfaces[0].positions.emplace_back(9.0F);
    scene.surfaces[0].normals.emplace_back(0.0F);
    scene.surfaces[0].uvs.emplace_back(0.0F);
    EXPECT_EQ(verticesOf(scene, {}, 4).visibility.back(), 1.0F);
}

} // namespace

} // namespace aolib::bake::test
