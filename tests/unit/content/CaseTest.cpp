#include "content/Case.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "SmallGltf.h"

namespace aolib {
namespace {

using test::replaced;

const std::string caseText =
    R"({"mesh":"bunny.obj","eye":[0.1,1.5,3],"target":[0,0.25,0],"up":[0,1,0],"fovy_deg":45,
    "near":0.1,"far":100,"width":960,"height":540,"radius":0.3,"falloff":"exp",
    "normals":"given","ground":-1.0})";

void expectCaseRefused(const std::string& json, const std::string& reason) {
    const Result<Case, LoadError> scene = parseCase(json, "cases/c.json");
    ASSERT_FALSE(scene.ok()) << json;
    EXPECT_EQ(scene.error().sentence.find("cases/c.json: "), 0U) << scene.error().sentence;
    EXPECT_NE(scene.error().sentence.find(reason), std::string::npos) << scene.error().sentence;
}

TEST(CaseTest, ReadsEveryKey) {
    const Result<Case, LoadError> scene = parseCase(caseText, "cases/c.json");
    ASSERT_TRUE(scene.ok()) << scene.error().sentence;
    EXPECT_EQ(scene->mesh, "bunny.obj");
    EXPECT_EQ(scene->eye, glm::vec3(0.1F, 1.5F, 3.0F));
    EXPECT_EQ(scene->target, glm::vec3(0.0F, 0.25F, 0.0F));
    EXPECT_EQ(scene->up, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene->fovyDeg, 45.0F);
    EXPECT_EQ(scene->near, 0.1F);
    EXPECT_EQ(scene->far, 100.0F);
    EXPECT_EQ(scene->width, 960);
    EXPECT_EQ(scene->height, 540);
    EXPECT_EQ(scene->radius, 0.3F);
    EXPECT_EQ(scene->falloff, Falloff::Exp);
    EXPECT_EQ(scene->normals, CaseNormals::Given);
    EXPECT_EQ(scene->ground, -1.0F);
    EXPECT_EQ(scene->folder, "cases");
}

TEST(CaseTest, GroundMayBeLeftOut) {
    const Result<Case, LoadError> scene =
        parseCase(replaced(caseText, R"(,"ground":-1.0)", ""), "c.json");
    ASSERT_TRUE(scene.ok()) << scene.error().sentence;
    EXPECT_FALSE(scene->ground.has_value());
}

TEST(CaseTest, WritingAndReadingGivesTheSame) {
    Case scene = *parseCase(caseText, "cases/c.json");
    scene.radius = 0.1F + 0.2F;
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp, Falloff::Off}) {
        scene.falloff = falloff;
        const std::string written = writeCase(scene);
        const Result<Case, LoadError> again = parseCase(written, "cases/c.json");
        ASSERT_TRUE(again.ok()) << again.error().sentence;
        EXPECT_EQ(again->mesh, scene.mesh);
        EXPECT_EQ(again->eye, scene.eye);
        EXPECT_EQ(again->target, scene.target);
        EXPECT_EQ(again->up, scene.up);
        EXPECT_EQ(again->fovyDeg, scene.fovyDeg);
        EXPECT_EQ(again->near, scene.near);
        EXPECT_EQ(again->far, scene.far);
        EXPECT_EQ(again->width, scene.width);
        EXPECT_EQ(again->height, scene.height);
        EXPECT_EQ(again->radius, scene.radius);
        EXPECT_EQ(again->falloff, falloff);
        EXPECT_EQ(again->normals, scene.normals);
        EXPECT_EQ(again->ground, scene.ground);
        EXPECT_EQ(writeCase(*again), written);
    }
    EXPECT_NE(writeCase(scene).find("\"near\": 0.1,"), std::string::npos) << writeCase(scene);
}

TEST(CaseTest, NamesMissingKeys) {
    for (const char* key : {"mesh", "eye", "target", "up", "fovy_deg", "near", "far", "width",
                            "height", "radius", "falloff", "normals"}) {
        const std::string quoted = std::string("\"") + key + "\"";
        const Result<Case, LoadError> scene = parseCase(
            replaced(replaced(caseText, quoted, "\"ground\""), "\"ground\":-1.0", "\"ground\":0"),
            "c.json");
        ASSERT_FALSE(scene.ok()) << key;
        EXPECT_NE(scene.error().sentence.find("'" + std::string(key) + "' is missing"),
                  std::string::npos)
            << scene.error().sentence;
    }
}

TEST(CaseTest, NamesUnknownKeys) {
    expectCaseRefused(replaced(caseText, "\"ground\"", "\"floor\""),
                      "'floor' is not a key of a case");
}

TEST(CaseTest, ChecksTypes) {
    expectCaseRefused(replaced(caseText, "\"bunny.obj\"", "7"), "'mesh' is not a text");
    expectCaseRefused(replaced(caseText, "\"bunny.obj\"", "\"\""), "'mesh' is not a text");
    expectCaseRefused(replaced(caseText, "[0.1,1.5,3]", "[0.1,1.5]"),
                      "'eye' is not a list of three");
    expectCaseRefused(replaced(caseText, "[0,0.25,0]", "[0,\"x\",0]"),
                      "'target' is not a finite number");
    expectCaseRefused(replaced(caseText, "[0,0.25,0]", "[0,null,0]"),
                      "'target' is not a finite number");
    expectCaseRefused(replaced(caseText, "[0,0.25,0]", "[0,1e39,0]"),
                      "'target' is not a finite number");
    expectCaseRefused(replaced(caseText, ":45", ":\"wide\""), "'fovy_deg' is not a finite number");
    expectCaseRefused(replaced(caseText, ":960", ":960.5"), "'width' is not a whole number");
    expectCaseRefused(replaced(caseText, "-1.0", "\"low\""), "'ground' is not a finite number");
    expectCaseRefused(replaced(caseText, "\"exp\"", "\"linear\""), "'falloff' is 'linear'");
    expectCaseRefused(replaced(caseText, "\"given\"", "\"smooth\""), "'normals' is 'smooth'");
    expectCaseRefused(replaced(caseText, "-1.0", "NaN"), "not valid JSON");
    expectCaseRefused(replaced(caseText, "-1.0", "1e999"), "c.json");
    expectCaseRefused("[1]", "a case is a JSON object");
    expectCaseRefused("", "not valid JSON");
}

TEST(CaseTest, ChecksRanges) {
    expectCaseRefused(replaced(caseText, ":45", ":0"), "'fovy_deg'");
    expectCaseRefused(replaced(caseText, ":45", ":180"), "'fovy_deg'");
    expectCaseRefused(replaced(caseText, "\"near\":0.1", "\"near\":0"), "'near' is not above 0");
    expectCaseRefused(replaced(caseText, "\"far\":100", "\"far\":0.1"),
                      "'far' is not above 'near'");
    expectCaseRefused(replaced(caseText, ":960", ":0"),
                      "'width' is not a whole number from 1 to 16384");
    expectCaseRefused(replaced(caseText, ":540", ":16385"), "'height'");
    expectCaseRefused(replaced(caseText, ":540", ":-5"), "'height'");
    expectCaseRefused(replaced(caseText, ":0.3", ":0"), "'radius' is not above 0");
    expectCaseRefused(replaced(caseText, "[0.1,1.5,3]", "[0,0.25,0]"), "'eye' and 'target'");
    expectCaseRefused(replaced(caseText, "[0,1,0]", "[0,0,0]"), "'up' is parallel");
    expectCaseRefused(replaced(caseText, "[0,1,0]", "[0.1,1.25,3]"), "'up' is parallel");
}

TEST(CaseTest, LoadsItsSceneWithItsGround) {
    Case scene = *parseCase(replaced(caseText, "bunny.obj", "cornell"), "cases/c.json");
    const Result<Model, LoadError> model = loadCaseModel(scene);
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    ASSERT_EQ(model->triangleCount(), 36U);
    const ModelMesh& ground = model->meshes.back();
    EXPECT_EQ(ground.name, "ground");
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(ground.positions[i].y, -1.0F);
        EXPECT_EQ(ground.normals[i], glm::vec3(0, 1, 0));
    }
    const glm::vec3& a = ground.positions[0];
    EXPECT_GT(glm::cross(ground.positions[1] - a, ground.positions[2] - a).y, 0.0F);
    EXPECT_NEAR(ground.positions[1].x - a.x, 20.0F * std::sqrt(300.0F), 0.1F);
    scene.ground.reset();
    EXPECT_EQ(loadCaseModel(scene)->triangleCount(), 34U);
}

TEST(CaseTest, FindsItsMeshBesideItself) {
    const std::filesystem::path folder = std::filesystem::path(AOLIB_TEST_FOLDER) / "cases";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "one.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(folder / "one.json") << replaced(caseText, "bunny.obj", "one.obj");
    const Result<Case, LoadError> scene = readCase(folder / "one.json");
    ASSERT_TRUE(scene.ok()) << scene.error().sentence;
    const Result<Model, LoadError> model = loadCaseModel(*scene);
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), 3U);
    EXPECT_TRUE(model->flattened().normals.empty()); // the ground adds none of its own
    EXPECT_NE(readCase(folder / "gone.json").error().sentence.find("gone.json"), std::string::npos);
}

TEST(CaseTest, GivesItsCamera) {
    const Case scene = *parseCase(caseText, "c.json");
    const NamedCamera camera = caseCamera(scene);
    EXPECT_EQ(camera.eye, scene.eye);
    EXPECT_EQ(camera.target, scene.target);
    EXPECT_EQ(camera.up, scene.up);
    EXPECT_EQ(camera.fovyDeg, 45.0F);
    EXPECT_EQ(camera.near, 0.1F);
    EXPECT_EQ(camera.far, 100.0F);
}

} // namespace
} // namespace aolib
