#include <exception>
#include <iostream>
#include <string>

#include <CLI/CLI.hpp>

#include "app/Commands.h"

namespace {

using aolib::app::ExitCode;

int exitWith(ExitCode code) {
    return static_cast<int>(code);
}

int run(int argc, char** argv) {
    CLI::App program("aolib: ambient occlusion from cube maps, for any OpenGL renderer");
    program.footer("Begin with:\n"
                   "  aolib scenes                      what there is to look at\n"
                   "  aolib render town -o out          pictures of a scene, and a table\n"
                   "  aolib view town                   the same in a window, with sliders\n"
                   "  aolib bake model.glb -o out.glb   occlusion into a model's textures\n"
                   "  aolib demo --out out              everything at once, compared with rays\n"
                   "\"aolib COMMAND --help\" explains a command.\n"
                   "Exit codes: 0 success, 1 failure, 2 bad input, 3 OpenGL failed.");
    aolib::app::MaybeFailure failure;
    aolib::app::addRenderCommand(program, failure);
    aolib::app::addCompareCommand(program, failure);
    aolib::app::addTruthCommand(program, failure);
    aolib::app::addScenesCommand(program, failure);
    aolib::app::addBenchCommand(program, failure);
    aolib::app::addBakeCommand(program, failure);
    aolib::app::addViewCommand(program, failure);
    aolib::app::addDemoCommand(program, failure);
    const std::string first = argc > 1 ? argv[1] : "";
    const bool known =
        !program
             .get_subcommands([&](const CLI::App* command) { return command->get_name() == first; })
             .empty();
    if (!known && (first.empty() || first[0] != '-')) {
        std::cerr << "aolib: " << (first.empty() ? "a command is needed" : first + " is no command")
                  << "; \"aolib --help\" lists them\n";
        return exitWith(ExitCode::BadInput);
    }
    program.require_subcommand(1);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& wish) { // --help
        return program.exit(wish);
    } catch (const CLI::ParseError& error) {
        std::cerr << "aolib: " << error.what() << '\n';
        return exitWith(ExitCode::BadInput);
    }
    if (failure) {
        std::cerr << "aolib: " << failure->sentence << '\n';
        return exitWith(failure->exit);
    }
    return exitWith(ExitCode::Ok);
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "aolib: " << error.what() << '\n';
    } catch (...) {
        std::cerr << "aolib: an unknown exception\n";
    }
    return exitWith(ExitCode::Failed);
}
