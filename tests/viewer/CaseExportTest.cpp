#include <gtest/gtest.h>

#include <filesystem>

#include "viewer/CaseExport.h"

namespace aolib::viewer {
namespace {

namespace fs = std::filesystem;

app::View roomView() {
    app::View view;
    view.scene = "room";
    view.ground = -0.25F;
    view.normals = host::SceneNormals::Model;
    return view;
}

NamedCamera exportedCamera() {
    return {"", {0.1F, 1.7F, 3.3F}, {0.3F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, 51.5F, 0.01F, 77.7F};
}

TEST(CaseExportTest, HoldsWhatIsSeenExactly) {
    Options options;
    options.radius = 1.0F / 3.0F;
    options.falloff = Falloff::Exp;
    const Case made = caseOf(roomView(), exportedCamera(), {641, 359}, options, ".");
    const Result<Case, LoadError> read = parseCase(writeCase(made), "some.json");
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_EQ(read->mesh, "room");
    EXPECT_EQ(read->eye, exportedCamera().eye);
    EXPECT_EQ(read->target, exportedCamera().target);
    EXPECT_EQ(read->fovyDeg, exportedCamera().fovyDeg);
    EXPECT_EQ(read->near, exportedCamera().near);
    EXPECT_EQ(read->far, exportedCamera().far);
    EXPECT_EQ(read->width, 641);
    EXPECT_EQ(read->height, 359);
    EXPECT_EQ(read->radius, options.radius);
    EXPECT_EQ(read->falloff, Falloff::Exp);
    EXPECT_EQ(read->normals, CaseNormals::Given);
    EXPECT_EQ(read->ground, -0.25F);
}

TEST(CaseExportTest, FilesAreNamedRelativeToTheCase) {
    app::View view;
    view.scene = "models/bunny.obj";
    EXPECT_EQ(caseOf(view, exportedCamera(), {8, 8}, {}, ".").mesh, "models/bunny.obj");
    EXPECT_EQ(caseOf(view, exportedCamera(), {8, 8}, {}, "cases").mesh, "../models/bunny.obj");
    view.scene = fs::absolute("models/bunny.obj").string();
    EXPECT_EQ(caseOf(view, exportedCamera(), {8, 8}, {}, ".").mesh, "models/bunny.obj");
}

TEST(CaseExportTest, TheCommandHasWhatACaseHasNot) {
    Options options;
    options.radius = 3.0F;
    options.estimator = Estimator::RayTraced;
    options.rayTraced.rays = 64;
    options.frameBudget = 30.0F; // says when, not what
    EXPECT_EQ(renderCommand("a.json", options, {}),
              "aolib render --case a.json --estimator ray-traced --texel-rays 64");
    CubeMapInfo cubeMap;
    cubeMap.position = {0.5F, 1.0F, -2.0F};
    EXPECT_EQ(renderCommand("a.json", options, {cubeMap}),
              "aolib render --case a.json --estimator ray-traced --texel-rays 64 "
              "--cube-map 0.5,1,-2");
    options.estimator = Estimator::Automatic; // what the command takes where none is named
    EXPECT_EQ(renderCommand("a.json", options, {}), "aolib render --case a.json --texel-rays 64");
    options.estimator = Estimator::HorizonSplit;
    options.backbone = Backbone::ScreenSpace;
    EXPECT_EQ(renderCommand("a.json", options, {cubeMap}),
              "aolib render --case a.json --backbone screenspace --estimator horizon-split "
              "--texel-rays 64");
}

} // namespace
} // namespace aolib::viewer
