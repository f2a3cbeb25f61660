#include "app/Commands.h"

#include <CLI/CLI.hpp>

namespace aolib::app {

void addViewCommand(CLI::App& program, MaybeFailure& failure) {
    CLI::App* command =
        program.add_subcommand("view", "show a scene in a window; this program is built without");
    command->allow_extras();
    command->callback([&failure] {
        failure =
            badInput("view: this program was built without the window, which needs Dear ImGui "
                     "and GLFW 3.3 (packages libimgui-dev and libglfw3-dev; \"scripts/setup\" "
                     "installs them); then build it again");
    });
}

} // namespace aolib::app
