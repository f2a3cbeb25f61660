#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../app/Program.h"

namespace aolib::test {

namespace {

/// `aolib bench`, run as a process.
class BenchCommandGLTest : public ProgramTest {
protected:
    void expectRejected(const std::vector<std::string>& arguments, const std::string& reason) {
        const ProgramRun rejected = run(arguments);
        EXPECT_EQ(rejected.exitCode, 2);
        EXPECT_NE(rejected.err.find(reason), std::string::npos) << rejected.err;
        EXPECT_TRUE(names().empty()) << "something was written";
    }
};

TEST_F(BenchCommandGLTest, RejectsWhatItDoesNotKnow) {
    expectRejected({"bench"}, "subcommand");
    expectRejected({"bench", "pareto", "--scene", "atlantis"}, "atlantis");
    expectRejected({"bench", "pareto", "--method", "magic-*"}, "magic-*");
    expectRejected({"bench", "pareto", "--radius", "3"}, "share of the scene's diagonal");
    expectRejected({"bench", "pareto", "--radius", "0%"}, "share of the scene's diagonal");
    expectRejected({"bench", "pareto", "--camera", "3"}, "--camera");
    expectRejected({"bench", "thesis", "--scene", "atlantis"}, "atlantis");
    expectRejected({"bench", "thesis", "--figure", "9.9"}, "face-size");
}

TEST_F(BenchCommandGLTest, ListsScenesAndMethods) {
    const ProgramRun list = run({"bench", "pareto", "--list"});
    EXPECT_EQ(list.exitCode, 0) << list.err;
    for (const char* word : {"sponza_ivy", "layered-8x16-512", "surfels-20k", "rays-16"}) {
        EXPECT_NE(list.out.find(word), std::string::npos) << word;
    }
    EXPECT_TRUE(names().empty());
}

TEST_F(BenchCommandGLTest, SaysThatAModelIsAbsentAndGoesOn) {
    const ProgramRun bench =
        run({"bench", "pareto", "--scene", "room", "--scene", "delft", "--method", "rays-1",
             "--width", "48", "--height", "27", "--rays", "8", "--out", "out"},
            {{"AOLIB_MODELS_DIR", "nowhere"}});
    ASSERT_EQ(bench.exitCode, 0) << bench.err;
    EXPECT_NE(bench.err.find("warning: left out: delft"), std::string::npos) << bench.err;
    EXPECT_NE(bench.out.find("rays-1"), std::string::npos) << bench.out;
    const nlohmann::json json = nlohmann::json::parse(bytesOf("out/pareto.json"));
    EXPECT_EQ(json["results"].size(), 4U); // two cameras, two radii
    EXPECT_EQ(json["machine"]["command"],
              "aolib bench pareto --scene room --scene delft --method rays-1 --width 48 --height "
              "27 --rays 8 --out out");
    EXPECT_GT(json["machine"]["cores"], 0);
    EXPECT_NE(json["machine"]["driver"], "");
    for (const char* file : {"out/pareto.csv", "out/pareto.svg", "out/pareto-build.png"}) {
        EXPECT_TRUE(std::filesystem::exists(path(file))) << file;
    }
}

TEST_F(BenchCommandGLTest, FailsWhenNothingIsThere) {
    const ProgramRun bench =
        run({"bench", "pareto", "--scene", "delft", "--method", "rays-1", "--out", "out"},
            {{"AOLIB_MODELS_DIR", "nowhere"}});
    EXPECT_EQ(bench.exitCode, 1);
    EXPECT_NE(bench.err.find("none of the scenes"), std::string::npos) << bench.err;
}

} // namespace

} // namespace aolib::test
