#include <gtest/gtest.h>

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/Commands.h"

namespace aolib::app {
namespace {

TEST(ViewAbsentTest, SaysWhatIsMissingAndHowToGetIt) {
    CLI::App program;
    MaybeFailure failure;
    addViewCommand(program, failure);
    program.parse("aolib view model.glb --compare truth", /*program_name_included=*/true);
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->exit, ExitCode::BadInput);
    for (const char* word :
         {"Dear ImGui", "GLFW", "libimgui-dev", "libglfw3-dev", "scripts/setup"}) {
        EXPECT_NE(failure->sentence.find(word), std::string::npos) << failure->sentence;
    }
    EXPECT_EQ(std::ranges::count(failure->sentence, '\n'), 0);
}

} // namespace
} // namespace aolib::app
