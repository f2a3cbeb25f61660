#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <aolib/OptionFields.h>

#include "Program.h"

namespace aolib::test {

namespace {

class BadInputTest : public ProgramTest {
protected:
    /// Exit code 2, one sentence on stderr that holds all the words, and not one file more.
    void expectRejected(const std::vector<std::string>& arguments,
                        const std::vector<std::string>& words) {
        const std::vector<std::string> before = names();
        const ProgramRun rejected = run(arguments);
        std::string line;
        for (const std::string& argument : arguments) {
            line += argument + " ";
        }
        EXPECT_EQ(rejected.exitCode, 2) << line << "\n" << rejected.err;
        EXPECT_EQ(rejected.out, "") << line;
        EXPECT_EQ(std::count(rejected.err.begin(), rejected.err.end(), '\n'), 1) << line << "\n"
                                                                                 << rejected.err;
        for (const std::string& word : words) {
            EXPECT_NE(rejected.err.find(word), std::string::npos)
                << line << "\nlacks: " << word << "\n"
                << rejected.err;
        }
        EXPECT_EQ(names(), before) << line;
    }
};

/// Tries values that do not fit on every option that visitOptions() shows it.
struct UnfitValues {
    std::function<void(const std::string& flag, const std::string& value)> reject;

    void expect(std::string_view name, const std::string& value) const {
        reject("--" + std::string(name), value);
    }
    void operator()(std::string_view name, int&, OptionRange range, std::string_view) const {
        expect(name, std::to_string(static_cast<int>(range.min) - 1));
        expect(name, std::to_string(static_cast<int>(range.max) + 1));
        expect(name, std::to_string(static_cast<int>(range.min)) + ".5");
    }
    void operator()(std::string_view name, float&, OptionRange range, std::string_view) const {
        expect(name, std::to_string(range.min - 1.0));
        expect(name, "nan");
        expect(name, "wide");
    }
    void operator()(std::string_view, bool&, std::string_view) const {} // takes no value
    template <typename E, std::size_t N>
    void operator()(std::string_view name, E&, const std::array<OptionChoice<E>, N>&,
                    std::string_view) const {
        expect(name, "nonsense");
    }
};

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(BadInputTest, CommandsAndOptionsThatAreNone) {
    expectRejected({}, {"a command is needed", "--help"});
    expectRejected({"rendr", "town"}, {"rendr", "no command"});
    expectRejected({"render", "plane", "--bogus"}, {"--bogus"});
    expectRejected({"render"}, {"scene", "--case"});
    expectRejected({"truth", "plane"}, {"--out"});
    expectRejected({"compare", "a.pfm"}, {"reference"});
}

TEST_F(BadInputTest, ScenesThatAreNone) {
    write("empty.obj", "");
    write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    write("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n");
    write("cut.glb", std::string("glTF\2\0\0\0\377\0\0\0", 12));
    const auto rejected = [&](const std::string& scene, const std::vector<std::string>& words) {
        expectRejected({"render", scene, "-o", "out"}, words);
        expectRejected({"truth", scene, "--out", "t.pfm"}, words);
    };
    rejected("nosuch", {"nosuch", "neither a file nor a generated scene"});
    rejected("nosuch.glb", {"nosuch.glb", "no such file"});
    rejected("empty.obj", {"empty.obj"});
    rejected("points.obj", {"points.obj", "triangle"});
    rejected("nan.obj", {"nan.obj", "line 1"});
    rejected("index.obj", {"index.obj", "line 4"});
    rejected("cut.glb", {"cut.glb"});
    rejected(".", {"not a regular file"});
}

TEST_F(BadInputTest, CasesThatAreNone) {
    write("text.json", "once upon a time");
    write("half.json", R"({"mesh":"plane","eye":[0,1,2]})");
    write("mesh.json", R"({"mesh":"gone.obj","eye":[0,1,5],"target":[0,0,0],"up":[0,1,0],)"
                       R"("fovy_deg":45,"near":0.1,"far":100,"width":16,"height":9,"radius":1,)"
                       R"("falloff":"step","normals":"geometric"})");
    expectRejected({"render", "--case", "gone.json"}, {"gone.json"});
    expectRejected({"render", "--case", "text.json"}, {"text.json", "JSON"});
    expectRejected({"render", "--case", "half.json"}, {"half.json"});
    expectRejected({"render", "--case", "mesh.json"}, {"gone.obj"});
    expectRejected({"render", "plane", "--case", "mesh.json"}, {"--case", "plane"});
    expectRejected({"render", "--case", "mesh.json", "--camera", "front"}, {"--camera"});
}

TEST_F(BadInputTest, ViewsThatAreNone) {
    const auto rejected = [&](const std::vector<std::string>& flags,
                              const std::vector<std::string>& words) {
        std::vector<std::string> arguments{"render", "plane", "--ao", "w.pfm"};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        expectRejected(arguments, words);
    };
    rejected({"--camera", "moon"}, {"--camera moon", "oblique"});
    rejected({"--eye", "1,2"}, {"--eye 1,2", "x,y,z"});
    rejected({"--eye", "nan,0,0"}, {"--eye nan,0,0"});
    rejected({"--eye", "1,2,3x"}, {"--eye 1,2,3x"});
    rejected({"--eye", "1e39,0,0"}, {"--eye 1e39,0,0"});
    rejected({"--eye", "-1,2,3", "--target", "-1,2,3"}, {"--target", "--eye"});
    rejected({"--eye", "0,5,0", "--target", "0,0,0"}, {"--up"});
    rejected({"--fovy", "180"}, {"--fovy", "180 degrees"});
    rejected({"--near", "2", "--far", "1"}, {"--near", "--far"});
    rejected({"--width", "0"}, {"--width 0"});
    rejected({"--height", "9.5"}, {"--height 9.5"});
    rejected({"--width", "1000000"}, {"--width", "16384"});
    rejected({"--ground", "inf"}, {"--ground inf"});
    rejected({"--normals", "bumpy"}, {"--normals bumpy", "geometric"});
    rejected({"--cube-map", "1,2"}, {"--cube-map 1,2"});
    rejected({"--frames", "0"}, {"--frames 0"});
    rejected({"--truth-rays", "1"}, {"--truth-rays 1"});
    rejected({"--context", "carrier-pigeon"}, {"--context carrier-pigeon", "egl"});
    rejected({"--profile", "es"}, {"--profile es", "core"});
}

TEST_F(BadInputTest, EveryOptionOfTheLibraryOutsideItsRange) {
    Options options;
    visitOptions(
        options, UnfitValues{[this](const std::string& flag, const std::string& value) {
            expectRejected({"render", "plane", "--ao", "w.pfm", flag, value}, {flag, value});
        }});
    expectRejected({"render", "plane", "--radius", "ten%"}, {"--radius ten%"});
    expectRejected({"render", "plane", "--blur-size", "4"}, {"blur-size", "4", "odd"});
}

TEST_F(BadInputTest, OutputsThatCannotBe) {
    write("file", kTriangle);
    expectRejected({"render", "plane", "--ao", "w.jpg"}, {"--ao w.jpg", ".pfm or .png"});
    expectRejected({"render", "plane", "--colour", "c.pfm"}, {"--colour c.pfm", ".png"});
    expectRejected({"render", "plane", "--ao", "gone/w.pfm"}, {"--ao", "no folder gone"});
    expectRejected({"render", "plane", "--ao", "a.png", "--colour", "a.png"}, {"a.png"});
    expectRejected({"render", "plane", "-o", "file"}, {"--out file", "not a folder"});
    expectRejected({"render", "plane", "-o", "file/deeper"}, {"--out file/deeper"});
    expectRejected({"render", "plane", "--debug", "faces"}, {"--debug faces", "--out"});
    expectRejected({"render", "plane", "--debug", "ghosts=g.png"}, {"--debug ghosts", "faces"});
    expectRejected({"demo", "--out", "file"}, {"--out file"});
    expectRejected({"demo", "--models", "gone"}, {"--models gone"});
}

TEST_F(BadInputTest, PicturesThatCannotBeCompared) {
    const std::string white = std::string("\0\0\200\77", 4);
    write("one.pfm", "Pf\n1 1\n-1\n" + white);
    write("two.pfm", "Pf\n2 1\n-1\n" + white + white);
    write("cut.pfm", "Pf\n9 9\n-1\n" + white);
    write("text.pfm", "once upon a time");
    expectRejected({"compare", "gone.pfm", "one.pfm"}, {"gone.pfm"});
    expectRejected({"compare", "one.pfm", "cut.pfm"}, {"cut.pfm"});
    expectRejected({"compare", "text.pfm", "one.pfm"}, {"text.pfm"});
    expectRejected({"compare", "one.pfm", "two.pfm"}, {"one.pfm and two.pfm"});
    expectRejected({"compare", "one.pfm", "one.pfm", "--difference", "d.bmp"}, {"d.bmp"});
    expectRejected({"compare", "one.pfm", "one.pfm", "--scale", "0"}, {"--scale"});
}

TEST_F(BadInputTest, WithoutAContextTheCodeIsThree) {
    const ProgramRun failed =
        run({"render", "plane", "--context", "egl", "-o", "out"}, {{"AOLIB_EGL_DEVICE", "999"}});
    EXPECT_EQ(failed.exitCode, 3);
    EXPECT_NE(failed.err.find("AOLIB_EGL_DEVICE"), std::string::npos) << failed.err;
    EXPECT_TRUE(names().empty());
}

} // namespace

} // namespace aolib::test
