// Texels of cube maps that rays tell.
#include "ProgressiveTest.h"

namespace aolib {
namespace {

class TracedTexelsGLTest : public ProgressiveTest {};

TEST_P(TracedTexelsGLTest, TracedTexelsFollowTheClosedForm) {
    Model model;
    addQuad(model, {0, 0, -60}, {0, 0, 60}, {60, 0, 60}, {60, 0, -60});
    addQuad(model, {0, 0, -60}, {0, 2, -60}, {0, 2, 60}, {0, 0, 60});
    Options o = options(Estimator::RayTraced);
    o.falloff = Falloff::Off;
    o.frameBudget = 0.0F;
    o.rayTraced.rays = 1024;
    SmallHost host = hostWith(o, model);
    const auto id = host.ao().addCubeMap({1.5F, 3.0F, 0.1F});
    ASSERT_TRUE(id.ok()) << id.status().message();
    const CubeMapImage cube = *host.ao().readCubeMap(*id);
    for (const float d : {0.5F, 1.0F, 2.0F}) {
        // A wall of height h, endless, at distance d: W = (1 + d / sqrt(d^2 + h^2)) / 2.
        const float expected = 0.5F * (1.0F + d / std::sqrt(d * d + 4.0F));
        EXPECT_NEAR(cube.visibility[texelTowards(cube, {d, 0, 0})], expected, 0.02F);
    }
}

TEST_P(TracedTexelsGLTest, WhatIsTracedTwiceCountsOnce) {
    Options o = options(Estimator::RayTraced);
    o.rayTraced.rays = 16; // one pass
    o.cubeMaps.refineStaticViews = false;
    SmallHost host = hostWith(o);
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    for (int frame = 0; frame < 200; ++frame) {
        // Each view asks for more, so that what is asked of the tracer changes while it works.
        const float angle = 0.05F * static_cast<float>(frame);
        host.lookAt({0.5F, 3, 5}, {0.5F + std::sin(angle), 2.5F, 5 - std::cos(angle)});
        ASSERT_TRUE(host.frame().ok());
        ASSERT_LE(host.ao().statistics().computed, 1.0F) << "frame " << frame;
    }
}

TEST_P(TracedTexelsGLTest, TracedTexelsFollowTheScene) {
    Model floor;
    addQuad(floor, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    SmallHost host = hostWith(options(Estimator::RayTraced), floor);
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_EQ(host.visibilityAt({0, 0, 1.3F}), 1.0F);
    Model box;
    addBox(box, {-1, 0, -1}, {1, 2, 1});
    const ModelMesh& mesh = box.meshes.front();
    const auto id =
        host.ao().addMesh({.positions = mesh.positions, .normals = {}, .indices = mesh.indices});
    ASSERT_TRUE(id.ok()) << id.status().message();
    ASSERT_GT(converge(host), 0);
    EXPECT_LT(host.visibilityAt({0, 0, 1.3F}), 0.8F) << "the box darkens the floor before it";
    ASSERT_TRUE(host.ao().removeMesh(*id).ok());
    ASSERT_GT(converge(host), 0);
    EXPECT_EQ(host.visibilityAt({0, 0, 1.3F}), 1.0F);
}

TEST_P(TracedTexelsGLTest, WithoutATracerTheFrameSaysSo) {
    SmallHost host(gl, loader, boxOnFloor(), options(Estimator::RayTraced));
    host.lookAt({0.5F, 3, 5}, {0, 0.5F, 0});
    ASSERT_TRUE(host.ao().addCubeMap({0.5F, 3, 5}).ok()) << "its turn comes in a frame";
    const AoStatus status = host.frame();
    EXPECT_EQ(status.code(), StatusCode::MissingCapability);
    EXPECT_NE(status.message().find("setTexelTracer"), std::string::npos) << status.message();
    host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
    EXPECT_GT(converge(host), 0);
    Options screen = options(Estimator::RayTraced);
    screen.backbone = Backbone::ScreenSpace;
    EXPECT_EQ(host.ao().setOptions(screen).code(), StatusCode::InvalidOption);
}

AOLIB_FOR_ALL_CONTEXTS(TracedTexelsGLTest);

} // namespace
} // namespace aolib
