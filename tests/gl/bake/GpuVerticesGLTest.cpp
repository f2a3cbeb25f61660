#include <cmath>

#include <glm/geometric.hpp>

#include "GpuBakerFixture.h"
#include "reference/ClosedForms.h"

namespace aolib::bake::test {

namespace {

/// Vertices baked on the GPU against closed forms, in every kind of context.
class GpuVerticesGLTest : public GpuBakerFixture {};

/// RMSE over the vertices of the floor beside the wall, cut into 8 x 8, of the middle row but for
/// the one in the wall.
double errorOfVertices(AbstractBaker& baker, VertexFit fit) {
    VertexOptions options;
    options.fit = fit;
    const auto vertices = baker.bakeVertices(options, {});
    EXPECT_TRUE(vertices.ok()) << vertices.status().message();
    EXPECT_EQ(vertices->front().visibility.size(), 81U);
    double sum = 0.0;
    for (int i = 1; i <= 8; ++i) {
        const double w{vertices->front().visibility[static_cast<std::size_t>(4 * 9 + i)]};
        sum += std::pow(w - (1.0 - wallOcclusion(0.5, i / 8.0)), 2.0);
    }
    return std::sqrt(sum / 8.0);
}

BakeScene finerFloorBesideShortWall() {
    UvMesh mesh;
    addUvQuad(mesh, glm::vec3(0.0F), {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, 8);
    BakeScene scene = sceneOf(mesh);
    scene.surfaces.push_back(floorBesideShortWall().surfaces[1]);
    return scene;
}

TEST_P(GpuVerticesGLTest, ShadowMapsLightVertices) {
    ShadowOptions options;
    options.directions = 256;
    options.depthSize = 512;
    const auto baker = shadow(finerFloorBesideShortWall(), options);
    EXPECT_LT(errorOfVertices(*baker, VertexFit::Direct), 0.02);
    EXPECT_LT(errorOfVertices(*baker, VertexFit::LeastSquares), 0.02);
    EXPECT_LT(errorOfVertices(*baker, VertexFit::TriangleMean), 0.04);
}

TEST_P(GpuVerticesGLTest, ScatteredPointsLightVertices) {
    // Neither needs UVs.
    BakeScene scene = finerFloorBesideShortWall();
    scene.surfaces[0].uvs.clear();
    ScatterOptions options;
    options.directions = 256;
    options.rasterSize = 128;
    const auto baker = scatter(std::move(scene), options);
    EXPECT_LT(errorOfVertices(*baker, VertexFit::Direct), 0.03);
    EXPECT_LT(errorOfVertices(*baker, VertexFit::LeastSquares), 0.02);
    const auto vertices = baker->bakeVertices({}, {});
    const glm::vec3& leaning = vertices->front().bentNormal[4 * 9 + 1];
    EXPECT_GT(leaning.x, 0.2F) << "away from the wall";
    EXPECT_NEAR(glm::length(leaning), 1.0F, 1e-5F);
    VertexOptions mean;
    mean.fit = VertexFit::TriangleMean;
    EXPECT_EQ(baker->bakeVertices(mean, {}).status().code(), StatusCode::MissingCapability);
    const auto cancelled = baker->bakeVertices({}, [](double done) { return done < 0.4; });
    EXPECT_EQ(cancelled.status().code(), StatusCode::Cancelled);
}

AOLIB_FOR_ALL_CONTEXTS(GpuVerticesGLTest);

} // namespace

} // namespace aolib::bake::test
