#include <string>

#include <aolib/OptionFields.h>

#include "Program.h"

namespace aolib::test {

namespace {

class HelpTest : public ProgramTest {};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(HelpTest, NamesEveryCommandAndExitCode) {
    const ProgramRun help = run({"--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_EQ(help.err, "");
    for (const char* word :
         {"render", "compare", "truth", "scenes", "bake", "bench", "view", "demo", "Exit codes"}) {
        EXPECT_TRUE(contains(help.out, word)) << word;
    }
}

TEST_F(HelpTest, OfACommandTeachesByExample) {
    for (const char* command : {"render", "compare", "truth", "bake", "bench", "demo"}) {
        const ProgramRun help = run({command, "--help"});
        EXPECT_EQ(help.exitCode, 0);
        EXPECT_TRUE(contains(help.out, std::string("Examples:\n  aolib "))) << command;
    }
    EXPECT_EQ(run({"scenes", "--help"}).exitCode, 0);
}

TEST_F(HelpTest, OfRenderHasEveryOptionOfTheLibrary) {
    const std::string help = run({"render", "--help"}).out;
    Options options;
    int count = 0;
    visitOptions(options, [&](std::string_view name, auto&, const auto&...) {
        EXPECT_TRUE(contains(help, "--" + std::string(name) + " ")) << name;
        ++count;
    });
    EXPECT_GT(count, 10);
}

TEST_F(HelpTest, ScenesAreListedWithTheirCameras) {
    const ProgramRun list = run({"scenes"}, {{"AOLIB_MODELS_DIR", "nowhere"}});
    EXPECT_EQ(list.exitCode, 0) << list.err;
    for (const char* scene :
         {"town", "room", "dome", "cornell", "plane", "wall", "disc", "sphere-inside"}) {
        EXPECT_TRUE(contains(list.out, std::string("\n") + scene + " ")) << scene;
    }
    EXPECT_TRUE(contains(list.out, "aerial")) << list.out;
}

} // namespace

} // namespace aolib::test
