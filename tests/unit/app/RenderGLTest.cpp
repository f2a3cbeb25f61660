#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "Program.h"
#include "image/Pfm.h"
#include "image/Png.h"

namespace aolib::test {

namespace {

/// The program's pictures, rendered in whatever context it finds.
class RenderGLTest : public ProgramTest {
protected:
    void expectSuccess(const std::vector<std::string>& arguments) {
        const ProgramRun rendered = run(arguments);
        ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
    }
};

const std::vector<std::string> kSmall{"--width", "96", "--height", "54", "--face-size", "64"};

std::vector<std::string> joined(std::vector<std::string> first,
                                const std::vector<std::string>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// A cube from -0.5 to 0.5 whose normals point away from its centre, as if it were a ball.
std::string roundedCube() {
    std::string text;
    for (int corner = 0; corner < 8; ++corner) {
        for (const char* kind : {"v", "vn"}) {
            text += kind;
            for (int axis = 0; axis < 3; ++axis) {
                text += (corner >> axis & 1) != 0 ? " 0.5" : " -0.5";
            }
            text += '\n';
        }
    }
    return text + "f 1//1 3//3 4//4 2//2\nf 5//5 6//6 8//8 7//7\nf 1//1 2//2 6//6 5//5\n"
                  "f 3//3 7//7 8//8 4//4\nf 1//1 5//5 7//7 3//3\nf 2//2 4//4 8//8 6//6\n";
}

TEST_F(RenderGLTest, CaseFileGivesTheSamePixelsAsTheCommandLine) {
    std::filesystem::create_directory(path("in"));
    write("in/cube.obj", roundedCube());
    write("in/case.json", R"({"mesh":"cube.obj","eye":[0.9,0.8,2.5],"target":[0,-0.1,0],)"
                          R"("up":[0,1,0.1],"fovy_deg":40,"near":0.5,"far":50,"width":96,)"
                          R"("height":54,"radius":0.75,"falloff":"exp","normals":"given",)"
                          R"("ground":-0.5})");
    const std::vector<std::string> byCase{"render", "--case", "in/case.json", "--face-size", "64"};
    const std::vector<std::string> byFlags{
        "render",  "in/cube.obj", "--eye",    "0.9,0.8,2.5", "--target", "0,-0.1,0",    "--up",
        "0,1,0.1", "--fovy",      "40",       "--near",      "0.5",      "--far",       "50",
        "--width", "96",          "--height", "54",          "--radius", "0.75",        "--falloff",
        "exp",     "--normals",   "given",    "--ground",    "-0.5",     "--face-size", "64"};
    expectSuccess(joined(byCase, {"-o", "a", "--truth-rays", "8"}));
    expectSuccess(joined(byFlags, {"-o", "b", "--truth-rays", "8"}));
    for (const char* file :
         {"ao.pfm", "ao.png", "colour.png", "composite.png", "truth.pfm", "difference.png"}) {
        EXPECT_TRUE(bytesOf(std::string("a/") + file) == bytesOf(std::string("b/") + file)) << file;
    }
    // Each of the case's values matters, and a flag overrides it.
    const std::vector<std::vector<std::string>> changes{
        {"--radius", "0.5"}, {"--falloff", "step"},      {"--ground", "-0.6"},
        {"--fovy", "41"},    {"--normals", "geometric"}, {"--eye", "0.9,0.8,2.6"},
        {"--up", "0,1,0"},   {"--target", "0,0,0"},      {"--width", "97"}};
    for (const std::vector<std::string>& change : changes) {
        expectSuccess(joined(joined(byCase, change), {"--ao", "c.pfm"}));
        EXPECT_TRUE(bytesOf("c.pfm") != bytesOf("a/ao.pfm")) << change[0];
    }
}

TEST_F(RenderGLTest, TheTableSaysWhichFramesItsTimesAreOf) {
    const auto table = [&](const std::vector<std::string>& options) {
        const ProgramRun rendered = run(joined(joined({"render", "cornell"}, options), kSmall));
        EXPECT_EQ(rendered.exitCode, 0) << rendered.err;
        EXPECT_NE(rendered.out.find("AO ms/frame computing  AO ms/frame converged"),
                  std::string::npos)
            << rendered.out;
        EXPECT_NE(rendered.out.find("workers idle"), std::string::npos) << rendered.out;
        // scene, triangles, cube maps, build
        std::istringstream row(rendered.out.substr(rendered.out.find("\ncornell") + 1));
        std::vector<std::string> cells(6);
        for (std::string& cell : cells) {
            row >> cell;
        }
        return std::pair(cells[4], cells[5]);
    };
    const auto [computing, converged] = table({"--estimator", "ray-traced"});
    EXPECT_NE(computing, "-");
    EXPECT_NE(converged, "-");
    const auto [none, atOnce] = table({"--estimator", "horizon-split"});
    EXPECT_EQ(none, "-") << "computed in the call that needs it";
    EXPECT_NE(atOnce, "-");
}

TEST_F(RenderGLTest, OptionsThatNothingReadsAreWarnedOf) {
    const auto warnings = [&](const std::vector<std::string>& options) {
        const ProgramRun rendered = run(joined(joined({"render", "plane"}, options), kSmall));
        EXPECT_EQ(rendered.exitCode, 0) << rendered.err;
        return rendered.err;
    };
    for (const char* flag : {"--directions", "--steps", "--slices", "--slice-steps", "--layers"}) {
        const std::string text = warnings({flag, "4", "--texel-rays", "16"});
        EXPECT_NE(text.find(std::string("warning: ") + flag + " has no effect"), std::string::npos)
            << text;
        EXPECT_EQ(text.find("--texel-rays"), std::string::npos) << text;
    }
    const std::vector<std::string> horizon{"--estimator", "horizon-split", "--directions",
                                           "2",           "--steps",       "2"};
    EXPECT_EQ(warnings(joined(horizon, {"--step-size", "0.1"})).find("warning"), std::string::npos);
    EXPECT_NE(warnings(joined(horizon, {"--step-size", "0.1", "--falloff", "none"}))
                  .find("--step-size has no effect"),
              std::string::npos);
    EXPECT_NE(warnings(joined(horizon, {"--texel-rays", "8"})).find("--texel-rays"),
              std::string::npos);
    EXPECT_NE(warnings({"--backbone", "screenspace", "--nearest", "3"}).find("--nearest"),
              std::string::npos);
}

TEST_F(RenderGLTest, PfmRowsGoFromBottomToTop) {
    // Seen level from above the plane: surface below, background (-1) above.
    const std::vector<std::string> view =
        joined({"plane", "--eye", "0,0.2,0.4", "--target", "0,0.2,0", "--width", "96"},
               {"--height", "54"});
    expectSuccess(joined({"render", "--ao", "w.pfm", "--face-size", "64"}, view));
    expectSuccess(joined({"truth", "--out", "t.pfm", "--rays", "8"}, view));
    for (const char* file : {"w.pfm", "t.pfm"}) {
        const std::string bytes = bytesOf(file);
        ASSERT_GT(bytes.size(), 96 * 54 * sizeof(float)) << file;
        const std::string header = bytes.substr(0, bytes.size() - 96 * 54 * sizeof(float));
        EXPECT_EQ(header.substr(0, 9), "Pf\n96 54\n") << file;
        std::vector<float> values(96 * 54);
        std::memcpy(values.data(), bytes.data() + header.size(), values.size() * sizeof(float));
        EXPECT_GT(values[48], 0.9F) << file << ": the first row is the bottom one";
        EXPECT_EQ(values[53 * 96 + 48], -1.0F) << file << ": the last row is the top one";
    }
}

TEST_F(RenderGLTest, RenderAndTruthSeeTheSameSurfaces) {
    expectSuccess(joined(
        {"render", "cornell", "--ao", "w.pfm", "--truth", "t.pfm", "--truth-rays", "8"}, kSmall));
    const ProgramRun compared = run({"compare", "w.pfm", "t.pfm", "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    // Edges may go either way in a few pixels; a flipped or shifted picture is off by hundreds.
    const Result<FloatImage, ImageError> w = readPfm(path("w.pfm"));
    const Result<FloatImage, ImageError> t = readPfm(path("t.pfm"));
    ASSERT_TRUE(w.ok() && t.ok());
    int differing = 0;
    int background = 0;
    for (std::size_t i = 0; i < w->pixels.size(); ++i) {
        differing += (w->pixels[i] < 0.0F) != (t->pixels[i] < 0.0F) ? 1 : 0;
        background += t->pixels[i] < 0.0F ? 1 : 0;
    }
    EXPECT_GT(background, 100);
    EXPECT_LT(differing, 20);
}

TEST_F(RenderGLTest, TruthCommandTracesWhatRenderTraces) {
    expectSuccess(joined({"render", "wall", "--truth", "a.pfm", "--truth-rays", "8"}, kSmall));
    expectSuccess(
        {"truth", "wall", "--rays", "8", "--width", "96", "--height", "54", "--out", "b.pfm"});
    EXPECT_TRUE(bytesOf("a.pfm") == bytesOf("b.pfm"));
}

TEST_F(RenderGLTest, RadiusMayBeAShareOfTheDiagonal) {
    expectSuccess({"truth", "disc", "--rays", "8", "--radius", "10%", "--out", "share.pfm",
                   "--width", "96", "--height", "54"});
    expectSuccess({"truth", "disc", "--rays", "8", "--out", "default.pfm", "--width", "96",
                   "--height", "54"});
    expectSuccess({"truth", "disc", "--rays", "8", "--radius", "5%", "--out", "half.pfm", "--width",
                   "96", "--height", "54"});
    EXPECT_TRUE(bytesOf("share.pfm") == bytesOf("default.pfm")); // which is 10%
    EXPECT_TRUE(bytesOf("share.pfm") != bytesOf("half.pfm"));
}

TEST_F(RenderGLTest, HandPlacedCubeMapsKeepPlacementOut) {
    // Behind the wall no pixel of this view is seen: a cube map by coverage would appear.
    const std::vector<std::string> base =
        joined({"render", "cornell", "--cube-map", "40,40,40", "--cube-map", "-40,40,40"}, kSmall);
    const ProgramRun manual = run(base);
    ASSERT_EQ(manual.exitCode, 0) << manual.err;
    EXPECT_NE(manual.out.find("  2  "), std::string::npos) << manual.out;
}

TEST_F(RenderGLTest, OutWritesEverythingAndNothingIsLeftOver) {
    expectSuccess(joined(
        {"render", "room", "-o", "new/out", "--debug", "all", "--truth-rays", "8", "--gl-debug"},
        kSmall));
    const std::vector<std::string> expected{"new",
                                            "new/out",
                                            "new/out/ao.pfm",
                                            "new/out/ao.png",
                                            "new/out/colour.png",
                                            "new/out/composite.png",
                                            "new/out/debug-ao.png",
                                            "new/out/debug-coverage.png",
                                            "new/out/debug-edges.png",
                                            "new/out/debug-faces.png",
                                            "new/out/debug-normals.png",
                                            "new/out/debug-positions.png",
                                            "new/out/debug-quality.png",
                                            "new/out/difference.png",
                                            "new/out/truth.pfm",
                                            "new/out/truth.png"};
    EXPECT_EQ(names(), expected);
    for (const std::string& name : expected) {
        if (name.size() > 4 && name.substr(name.size() - 4) == ".png") {
            const Result<ByteImage, ImageError> picture = readPng(path(name));
            ASSERT_TRUE(picture.ok()) << picture.error().message;
            EXPECT_EQ(picture->width, 96);
            EXPECT_EQ(picture->height, 54);
        }
    }
}

TEST_F(RenderGLTest, CompositeIsDarkerThanTheColourAndContrastSaysHowMuch) {
    expectSuccess(joined({"render", "room", "-o", "full"}, kSmall));
    expectSuccess(joined({"render", "room", "-o", "none", "--contrast", "0"}, kSmall));
    const auto sum = [&](const char* file) {
        const Result<ByteImage, ImageError> picture = readPng(path(file));
        EXPECT_TRUE(picture.ok()) << picture.error().message;
        double total = 0.0;
        for (const std::uint8_t value : picture->pixels) {
            total += value;
        }
        return total;
    };
    EXPECT_LT(sum("full/composite.png"), 0.97 * sum("full/colour.png"));
    EXPECT_EQ(sum("none/composite.png"), sum("none/colour.png"));
}

TEST_F(RenderGLTest, DemoShowsEveryModelAndNamesTheBrokenOne) {
    std::filesystem::create_directory(path("models"));
    write("models/quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    write("models/broken.obj", "f 1 2 3\n");
    const ProgramRun demo =
        run({"demo", "--out", "out", "--models", "models", "--width", "96", "--height", "54",
             "--rays", "8", "--face-size", "64", "--gl-debug"});
    EXPECT_EQ(demo.exitCode, 2);
    EXPECT_NE(demo.err.find("broken.obj"), std::string::npos) << demo.err;
    for (const char* scene : {"town", "room", "dome", "quad"}) {
        for (const char* ending : {"", "-ao", "-colour", "-composite", "-difference", "-truth"}) {
            const std::string file = std::string("out/") + scene + ending + ".png";
            EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
        }
        EXPECT_NE(demo.out.find(std::string("\n") + scene + " "), std::string::npos) << demo.out;
    }
    EXPECT_FALSE(std::filesystem::exists(path("out/broken.png")));
}

} // namespace

} // namespace aolib::test
