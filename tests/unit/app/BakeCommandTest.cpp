#include <algorithm>
#include <cmath>
#include <filesystem>

#include "BakeProgramTest.h"
#include "content/SceneSource.h"
#include "image/Pfm.h"
#include "image/Png.h"

namespace aolib::test {
namespace {

class BakeCommandTest : public BakeProgramTest {};

TEST_F(BakeCommandTest, ATextureGoesIntoTheMaterialAndIntoFiles) {
    expectDone({"bake", "uv-shapes", "-o", "out.glb", "--ao", "ao.pfm", "--bent-normals",
                "bent.png", "--size", "64", "--rays", "64"});
    EXPECT_EQ(names(), (std::vector<std::string>{"ao.pfm", "bent.png", "out.glb"}));
    const Json json = jsonOf("out.glb");
    EXPECT_EQ(json["materials"][0]["occlusionTexture"]["index"], 0);
    EXPECT_EQ(json["images"].size(), 1U);
    const auto map = readPfm(path("ao.pfm"));
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_GT(at(*map, 0.5F, 0.97F), 0.5F) << "the sphere's upper pole";
    EXPECT_LT(at(*map, 0.5F, 0.55F), 0.1F) << "its lower pole, above the box's floor";
    EXPECT_EQ(at(*map, 0.75F, 0.1F), 1.0F) << "outside the box";
    const auto bent = readPng(path("bent.png"));
    ASSERT_TRUE(bent) << bent.error().message;
    EXPECT_EQ(bent->channels, 3);
    EXPECT_GT(bent->at(32, 62, 1), 240) << "the upper pole's points up";
}

TEST_F(BakeCommandTest, FlagsThatNothingReadsAreWarnedOf) {
    const auto warnings = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"bake", "uv-box", "--ao", "ao.png", "--size", "16"});
        const ProgramRun done = run(options);
        EXPECT_EQ(done.exitCode, 0) << done.err;
        return done.err;
    };
    const std::vector<std::vector<std::string>> unused{
        {"--directions", "8"}, {"--raster", "64"}, {"--depth-size", "64"},  {"--no-stretch"},
        {"--fit", "direct"},   {"--density", "2"}, {"--camera", "front"},   {"--animation", "0"},
        {"--falloff", "exp"},  {"--bias", "2"},    {"--seams", "coverage"}, {"--width", "16"}};
    for (const std::vector<std::string>& flag : unused) {
        std::vector<std::string> options{"--rays", "4"};
        options.insert(options.end(), flag.begin(), flag.end());
        const std::string text = warnings(options);
        EXPECT_NE(text.find("warning: " + flag[0] + " has no effect"), std::string::npos) << text;
        EXPECT_EQ(text.find("--rays"), std::string::npos) << text;
    }
    EXPECT_EQ(warnings({"--rays", "4", "--sampling", "stratified", "--falloff", "exp", "--radius",
                        "1", "--texel-samples", "4", "--padding", "2"})
                  .find("warning"),
              std::string::npos);
}

TEST_F(BakeCommandTest, MapsMayBeExr) {
    expectDone({"bake", "uv-box", "--ao", "ao.exr", "--bent-normals", "bent.exr", "--size", "16",
                "--rays", "4"});
    EXPECT_EQ(bytesOf("ao.exr").substr(0, 4), "\x76\x2f\x31\x01");
    // Three floats a texel, a number and a size per row.
    EXPECT_GT(bytesOf("bent.exr").size(), 16U * (16U * 12U + 16U));
}

TEST_F(BakeCommandTest, SixteenBitsAreWrittenWhenAskedFor) {
    expectDone({"bake", "uv-box", "--ao", "ao.png", "--size", "16", "--rays", "4", "--bits", "16"});
    EXPECT_EQ(bytesOf("ao.png")[24], 16);
}

TEST_F(BakeCommandTest, VerticesGetAttributesOrColours) {
    expectDone({"bake", "cornell", "-o", "ao.glb", "--target", "vertex", "--rays", "16"});
    const Json mesh = jsonOf("ao.glb")["meshes"][0]["primitives"][0]["attributes"];
    EXPECT_TRUE(mesh.contains("_AO"));
    EXPECT_TRUE(mesh.contains("_BENT_NORMAL"));
    for (const char* fit : {"triangle-mean", "least-squares"}) {
        expectDone({"bake", "cornell", "-o", "color.glb", "--target", "vertex", "--rays", "16",
                    "--attribute", "color", "--fit", fit});
        EXPECT_TRUE(
            jsonOf("color.glb")["meshes"][0]["primitives"][0]["attributes"].contains("COLOR_0"));
    }
    expectRefused({"bake", "color.glb", "-o", "again.glb", "--target", "vertex", "--attribute",
                   "color", "--rays", "1"},
                  {"vertex colours already"});
}

TEST_F(BakeCommandTest, PosesGetAnAttributeEach) {
    expectDone({"bake", "hinge", "-o", "out.glb", "--target", "vertex", "--poses", "0,0.5,2",
                "--rays", "32"});
    const Json json = jsonOf("out.glb");
    for (const Json& mesh : json["meshes"]) {
        const Json& primitive = mesh["primitives"][0];
        EXPECT_EQ(primitive["extras"]["aolib_pose_times"], (std::vector<float>{0.0F, 0.5F, 2.0F}));
        for (const char* name :
             {"_AO_0", "_AO_1", "_AO_2", "_BENT_NORMAL_0", "_BENT_NORMAL_1", "_BENT_NORMAL_2"}) {
            ASSERT_TRUE(primitive["attributes"].contains(name)) << name;
            const Json& accessor =
                json["accessors"][primitive["attributes"][name].get<std::size_t>()];
            EXPECT_EQ(accessor["count"], json["accessors"][0]["count"]);
        }
        EXPECT_FALSE(primitive["attributes"].contains("_AO"));
        EXPECT_FALSE(primitive["attributes"].contains("_BENT_NORMAL"));
    }
    EXPECT_EQ(json["animations"].size(), 1U) << "and it still moves";
    const std::string table = run({"bake", "hinge", "-o", "again.glb", "--target", "vertex",
                                   "--poses", "0,2", "--rays", "32"})
                                  .out;
    EXPECT_NE(table.find("lid"), std::string::npos) << table;
    expectRefused({"bake", "hinge", "-o", "no.glb", "--poses", "0,1"}, {"--target vertex"});
    expectRefused({"bake", "hinge", "-o", "no.glb", "--target", "vertex", "--poses", "1,0"},
                  {"growing"});
    expectRefused({"bake", "cornell", "-o", "no.glb", "--target", "vertex", "--poses", "0,1"},
                  {"0 animations"});
}

TEST_F(BakeCommandTest, WhereThereAreNoUvsTheyAreMadeOrTheLackIsTold) {
    expectDone({"bake", "cornell", "-o", "out.glb", "--size", "128", "--rays", "16"});
    const Json json = jsonOf("out.glb");
    EXPECT_EQ(json["images"].size(), 5U);
    for (const Json& mesh : json["meshes"]) {
        EXPECT_TRUE(mesh["primitives"][0]["attributes"].contains("TEXCOORD_0"));
    }
    expectRefused({"bake", "cornell", "-o", "no.glb", "--unwrap", "never"},
                  {"of 6 triangles 6 have no UVs", "--unwrap auto"});
    // Baked once more, the file's own UVs will do.
    const ProgramRun again = run({"bake", "out.glb", "-o", "again.glb", "--unwrap", "never",
                                  "--size", "128", "--rays", "1"});
    EXPECT_EQ(again.exitCode, 0) << again.err;
}

TEST_F(BakeCommandTest, MethodsOnTheGpuGiveTheSameMap) {
    for (const std::string radius : {"0", "10%"}) {
        expectDone({"bake", "uv-shapes", "--ao", "rays.pfm", "--size", "64", "--rays", "256",
                    "--radius", radius});
        for (const char* method : {"scatter", "shadow"}) {
            expectDone({"bake", "uv-shapes", "-o", "out.glb", "--ao", "gpu.pfm", "--size", "64",
                        "--method", method, "--directions", "128", "--depth-size", "256",
                        "--radius", radius});
            EXPECT_EQ(jsonOf("out.glb")["images"].size(), 1U);
            const auto rays = readPfm(path("rays.pfm"));
            const auto gpu = readPfm(path("gpu.pfm"));
            ASSERT_TRUE(rays && gpu);
            for (const float v : {0.55F, 0.65F, 0.75F, 0.85F, 0.95F}) {
                EXPECT_NEAR(at(*gpu, 0.5F, v), at(*rays, 0.5F, v), 0.12F)
                    << method << " at " << v << ", radius " << radius;
            }
        }
    }
    for (const char* method : {"scatter", "shadow"}) {
        expectDone({"bake", "uv-shapes", "-o", "v.glb", "--target", "vertex", "--method", method,
                    "--directions", "8", "--depth-size", "64", "--raster", "64", "--fit",
                    "least-squares"});
        EXPECT_TRUE(jsonOf("v.glb")["meshes"][0]["primitives"][0]["attributes"].contains("_AO"));
    }
    expectRefused({"bake", "uv-shapes", "-o", "w.glb", "--target", "vertex", "--method", "scatter",
                   "--fit", "triangle-mean"},
                  {"LeastSquares fits them"});
    expectRefused({"bake", "uv-shapes", "-o", "w.glb", "--method", "shadow", "--radius", "0.01%"},
                  {"radius", "at least", "512th of the scene's diagonal"});
}

TEST_F(BakeCommandTest, ACameraGetsAPicture) {
    const std::vector<std::string> size{"--camera", "front", "--width", "48", "--height", "27"};
    const auto with = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), size.begin(), size.end());
        return arguments;
    };
    expectDone(with({"truth", "cornell", "--radius", "1000", "--rays", "256", "--normals", "given",
                     "--out", "truth.pfm"}));
    const auto truth = readPfm(path("truth.pfm"));
    ASSERT_TRUE(truth);
    for (const char* method : {"rays", "shadow"}) {
        expectDone(
            with({"bake", "cornell", "--target", "camera", "--method", method, "--directions",
                  "128", "--depth-size", "512", "--ao", "ao.pfm", "--bent-normals", "bent.png"}));
        const auto picture = readPfm(path("ao.pfm"));
        ASSERT_TRUE(picture);
        double sum = 0.0;
        int shown = 0;
        for (std::size_t i = 0; i < truth->pixels.size(); ++i) {
            shown += truth->pixels[i] >= 0.0F ? 1 : 0;
            sum += std::abs(double(picture->pixels[i]) - double(truth->pixels[i]));
        }
        EXPECT_GT(shown, 300);
        EXPECT_LT(sum / shown, 0.02) << method << ", background -1 in both";
    }
    expectRefused(with({"bake", "cornell", "--target", "camera", "-o", "a.glb"}), {"--ao"});
    expectRefused({"bake", "cornell", "--target", "camera", "--ao", "a.png", "--camera", "none"},
                  {"--camera none", "front"});
    expectRefused({"bake", "cornell", "--target", "camera", "--ao", "a.png", "--method", "scatter"},
                  {"view's pixels"});
}

TEST_F(BakeCommandTest, ManyModelsGoToAFolder) {
    std::filesystem::create_directory(path("made"));
    expectDone({"bake", "uv-box", "uv-sphere", "-o", "made", "--size", "16", "--rays", "1"});
    EXPECT_EQ(names(), (std::vector<std::string>{"made", "made/uv-box.glb", "made/uv-sphere.glb"}));
    expectRefused({"bake", "uv-box", "uv-sphere", "-o", "one.glb"}, {"--out", "folder"});
}

TEST_F(BakeCommandTest, TheBenchWritesATableAndAPlot) {
    const ProgramRun done =
        run({"bench", "bake", "--mesh", "bumps-400", "--mesh", "uv-box", "--samples", "4", "--size",
             "32", "--truth-rays", "4", "--out", "made"});
    EXPECT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(names(), (std::vector<std::string>{"made", "made/bake.csv", "made/bake.md",
                                                 "made/bake.png", "made/bake.svg"}));
    const std::string csv = bytesOf("made/bake.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 3) << csv;
    EXPECT_NE(csv.find("\nbumps-400,360,32,scatter,4,"), std::string::npos) << csv;
    expectRefused({"bench", "bake", "--mesh", "bumps-none"}, {"--mesh", "bumps-N"});
    expectRefused({"bench", "bake", "--mesh", "cornell"}, {"5 materials"});
}

TEST_F(BakeCommandTest, TheBenchGoesOnWhereItWasStopped) {
    const std::vector<std::string> first{
        "bench", "bake",         "--mesh", "uv-box",   "--samples", "4",   "--size",
        "16",    "--truth-rays", "4",      "--resume", "--out",     "made"};
    expectDone(first);
    const std::string before = bytesOf("made/bake.csv");
    expectDone(first);
    EXPECT_EQ(bytesOf("made/bake.csv"), before) << "times of a second run would be others";
    EXPECT_TRUE(std::filesystem::exists(path("made/truths/uv-box-16-4.pfm")));
    expectDone({"bench", "bake", "--mesh", "uv-box", "--samples", "8", "--size", "16",
                "--truth-rays", "4", "--method", "rays", "--resume", "--out", "made"});
    const std::string after = bytesOf("made/bake.csv");
    EXPECT_EQ(after.substr(0, before.size()), before);
    EXPECT_NE(after.find("\nuv-box,192,16,rays,8,"), std::string::npos) << after;
}

TEST_F(BakeCommandTest, RealModelsKeepTheirOwnUvs) {
    const auto folder = defaultModelsDir();
    for (const char* name : {"boombox.glb", "flight_helmet.glb"}) {
        if (!folder || !std::filesystem::exists(*folder / name)) {
            GTEST_SKIP() << "NOT TESTED: there is no " << name << " in AOLIB_MODELS_DIR";
        }
        const std::string model = std::filesystem::absolute(*folder / name).string();
        const ProgramRun done = run({"bake", model, "-o", name, "--size", "256", "--rays", "2"});
        EXPECT_EQ(done.exitCode, 0) << done.err;
        EXPECT_NE(done.out.find("TEXCOORD_0"), std::string::npos) << done.out;
        for (const Json& material : jsonOf(name)["materials"]) {
            EXPECT_TRUE(material.contains("occlusionTexture")) << material;
        }
    }
}

} // namespace
} // namespace aolib::test
