#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "GpuBakerFixture.h"
#include "raytracing/RayScene.h"
#include "reference/ClosedForms.h"
#include "reference/PictureTracer.h"

namespace aolib::bake::test {

namespace {

/// Bakes of what a view shows.
class ViewGLTest : public GpuBakerFixture {
protected:
    std::unique_ptr<AbstractBaker> rays(BakeScene scene) const {
        auto baker = createRayBaker(std::move(scene), {});
        EXPECT_TRUE(baker.ok());
        return std::move(*baker);
    }
    std::unique_ptr<AbstractBaker> shadowMaps(BakeScene scene) const {
        ShadowOptions options;
        options.directions = 256;
        options.depthSize = 512;
        return shadow(std::move(scene), options);
    }
};

/// The shapes from above, and W at the same pixels by another tracer.
Picture shapesFromAbove() {
    const UvMesh mesh = uvShape("uv-shapes");
    TriangleMesh triangles;
    triangles.positions = mesh.positions;
    triangles.indices = mesh.indices;
    const auto scene = RayScene::create(std::move(triangles));
    PictureCamera camera;
    camera.view =
        glm::lookAt(glm::dvec3(2.0, 5.0, 3.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0));
    camera.projection = glm::perspective(0.8, 1.5, 0.1, 100.0);
    camera.width = 48;
    camera.height = 32;
    PictureSettings settings;
    settings.trace.rays = 512;
    settings.trace.radius = 1000.0;
    settings.surfaces = true;
    auto picture = tracePicture(*scene, camera, settings);
    EXPECT_TRUE(picture.ok());
    return std::move(*picture);
}

TEST_P(ViewGLTest, APictureIsThatOfTheTruthAtItsPixels) {
    const Picture truth = shapesFromAbove();
    ViewPixels view{truth.width, truth.height, truth.position, truth.normal, {}, 0.0F};
    for (const auto& [baker, bound] : {std::pair(rays(sceneOf(shapes())).release(), 0.015),
                                       std::pair(shadowMaps(sceneOf(shapes())).release(), 0.03)}) {
        const std::unique_ptr<AbstractBaker> owner(baker);
        const auto picture = owner->bakeView(view, {});
        ASSERT_TRUE(picture.ok()) << picture.status().message();
        double sum = 0.0;
        int seen = 0;
        for (std::size_t i = 0; i < truth.visibility.size(); ++i) {
            const float w = picture->visibility[i];
            if (truth.visibility[i] < 0.0F) {
                EXPECT_EQ(w, -1.0F);
                EXPECT_EQ(picture->kind[i], TexelKind::Empty);
                continue;
            }
            EXPECT_NEAR(glm::length(picture->bentNormal[i]), 1.0F, 1e-4F);
            sum += std::pow(double(w) - double(truth.visibility[i]), 2.0);
            ++seen;
        }
        EXPECT_GT(seen, 200);
        EXPECT_LT(seen, 48 * 32) << "some of it is background";
        EXPECT_LT(std::sqrt(sum / seen), bound);
    }
}

/// Five pixels of the floor beside a wall, the third of which shows nothing.
ViewPixels floorPixels() {
    ViewPixels view;
    view.width = 5;
    view.height = 1;
    for (int i = 0; i < 5; ++i) {
        view.positions.emplace_back(0.1F + 0.2F * float(i), 0.0F, -0.5F);
        view.normals.emplace_back(0.0F, i == 2 ? 0.0F : 2.0F, 0.0F);
    }
    return view;
}

TEST_P(ViewGLTest, PlacesMayLieBelowTheirSurface) {
    ViewPixels view = floorPixels();
    for (glm::vec3& position : view.positions) {
        position.y = -0.001F;
    }
    const auto tracer = rays(floorBesideShortWall());
    const auto shadower = shadowMaps(floorBesideShortWall());
    EXPECT_LT(tracer->bakeView(view, {})->visibility[0], 0.01F) << "in the dark";
    view.lift = 0.0011F;
    for (AbstractBaker* baker : {tracer.get(), shadower.get()}) {
        const auto lifted = baker->bakeView(view, {});
        ASSERT_TRUE(lifted.ok());
        EXPECT_EQ(lifted->visibility[2], -1.0F);
        for (const std::size_t i : {0U, 1U, 3U, 4U}) {
            EXPECT_NEAR(lifted->visibility[i], 1.0 - wallOcclusion(0.5, 0.1 + 0.2 * double(i)),
                        0.03);
        }
    }
}

TEST_P(ViewGLTest, EveryMisuseHasItsCode) {
    const auto baker = shadowMaps(floorBesideShortWall());
    const auto code = [&](const ViewPixels& view) {
        return baker->bakeView(view, {}).status().code();
    };
    EXPECT_EQ(code({}), StatusCode::InvalidOption);
    ViewPixels view = floorPixels();
    view.planes.resize(3);
    EXPECT_EQ(code(view), StatusCode::InvalidOption);
    view = floorPixels();
    view.lift = -1.0F;
    EXPECT_EQ(code(view), StatusCode::InvalidOption);
    view = floorPixels();
    view.positions[1].x = NAN;
    EXPECT_EQ(code(view), StatusCode::InvalidPosition);
    view = floorPixels();
    view.normals[1].x = INFINITY;
    EXPECT_EQ(code(view), StatusCode::InvalidNormal);
    view = floorPixels();
    view.normals.assign(5, glm::vec3(0.0F));
    EXPECT_EQ(baker->bakeView(view, {})->visibility, std::vector<float>(5, -1.0F));
    EXPECT_EQ(rays(floorBesideShortWall())->bakeView(view, {})->visibility[0], -1.0F);
    EXPECT_EQ(scatter(floorBesideShortWall(), {})->bakeView(floorPixels(), {}).status().code(),
              StatusCode::MissingCapability);
    EXPECT_EQ(baker->bakeView(floorPixels(), [](double) { return false; }).status().code(),
              StatusCode::Cancelled);
}

// Contexts share one rasteriser; what takes seconds is done in one of them.
INSTANTIATE_TEST_SUITE_P(One, ViewGLTest, testing::Values(testContexts().front()), nameOf);

} // namespace

} // namespace aolib::bake::test
