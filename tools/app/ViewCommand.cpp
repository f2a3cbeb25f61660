#include "app/Commands.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/NumberFlags.h"
#include "app/OptionFlags.h"
#include "app/OutputFiles.h"
#include "app/ResolveOptions.h"
#include "app/ViewFlags.h"
#include "content/EnvironmentSource.h"
#include "viewer/Viewer.h"

namespace aolib::app {

namespace {

constexpr int kMostFrames = 1000000;
/// The picture's size where nothing says it: with the panel the window has 1280 x 720 pixels.
constexpr int kWidth = 940;
constexpr int kHeight = 720;

struct ViewCommandFlags {
    ViewFlags view;
    OptionFlags options;
    viewer::ViewerSettings settings;
};

MaybeFailure checkFiles(const viewer::ViewerSettings& settings) {
    OutputFiles files;
    if (!settings.screenshot.empty()) {
        if (MaybeFailure failure = files.announce("--screenshot", settings.screenshot, {".png"})) {
            return failure;
        }
    }
    if (!settings.stateFile.empty()) {
        if (MaybeFailure failure = files.announce("--state", settings.stateFile, {".json"})) {
            return failure;
        }
    }
    std::error_code ignored;
    if (!std::filesystem::is_directory(settings.folder, ignored)) {
        return badInput("--folder " + settings.folder + ": there is no such folder");
    }
    return std::nullopt;
}

MaybeFailure show(const ViewCommandFlags& flags) {
    if (MaybeFailure failure = checkFiles(flags.settings)) {
        return failure;
    }
    if (flags.settings.compared == viewer::ComparedMethod::Environment) {
        if (const auto map = openEnvironment(flags.settings.environment); !map) {
            return badInput(map.error().sentence);
        }
    }
    Result<View, Failure> view = flags.view.open();
    if (!view) {
        return view.error();
    }
    viewer::ViewerSettings settings = flags.settings;
    settings.options = resolveOptions(*view, flags.options);
    if (!flags.options.given("frame-budget")) {
        settings.options.frameBudget = Options().frameBudget; // a window must not wait
    }
    settings.invited = flags.view.named();
    settings.view = std::move(*view);
    Result<std::unique_ptr<viewer::Viewer>, Failure> window =
        viewer::Viewer::open(std::move(settings));
    return window ? (*window)->run() : window.error();
}

void attachWindow(CLI::App& command, viewer::ViewerSettings& settings) {
    const char* const group = "Window";
    std::vector<std::pair<std::string, viewer::ComparedMethod>> references;
    for (const viewer::ComparedMethodChoice& choice : viewer::kComparedMethods) {
        references.emplace_back(choice.name, choice.value);
    }
    addChoice<viewer::ComparedMethod>(
        command, "--compare", references,
        [&](viewer::ComparedMethod compared) { settings.compared = compared; },
        "what the right part of the picture shows")
        ->default_str("none")
        ->group(group);
    addNumber(
        command, "--split",
        [&](double share) {
            if (!(share > 0.0 && share < 1.0)) {
                throw CLI::ValidationError("--split: a share between 0 and 1 is needed");
            }
            settings.split = static_cast<float>(share);
        },
        "share of the picture's width that lies left of the line [0.5]")
        ->group(group);
    addWholeNumber(
        command, "--truth-rays", 2, kMostRays, [&](int rays) { settings.truthRays = rays; },
        "rays per pixel of the truth")
        ->default_str(std::to_string(settings.truthRays))
        ->group(group);
    const auto takeEnvironment = [&](const std::string& name) {
        settings.environment = name;
        settings.compared = viewer::ComparedMethod::Environment;
    };
    command
        .add_option_function<std::string>(
            "--environment", takeEnvironment,
            "light the right part by this: a .hdr file, or one of sunny, sunset, overcast, studio, "
            "window")
        ->type_name("ENVIRONMENT")
        ->group(group);
    addNumber(
        command, "--turn",
        [&](double degrees) { settings.turn = static_cast<float>(std::remainder(degrees, 360.0)); },
        "turn the environment about the vertical, degrees")
        ->group(group);
    addWholeNumber(
        command, "--lit-rays", 1, kMostRays, [&](int rays) { settings.light.rays = rays; },
        "rays per vertex that the environment's light is baked with")
        ->default_str(std::to_string(settings.light.rays))
        ->group(group);
    addNumber(
        command, "--lit-edge",
        [&](double percent) {
            if (!(percent > 0.0)) {
                throw CLI::ValidationError("--lit-edge must be above 0");
            }
            settings.light.edge = percent / 100.0;
        },
        "for which edges are cut that are longer, percent of the scene's diagonal")
        ->default_str("0.5")
        ->group(group);
    const auto flag = [&](const char* name, bool& into, bool value, const char* help) {
        command
            .add_flag_function(
                name, [&into, value](std::int64_t) { into = value; }, help)
            ->group(group);
    };
    command
        .add_flag_function(
            "--walk", [&](std::int64_t) { settings.mode = viewer::CameraMode::Walk; },
            "walk with W A S D and the mouse instead of turning about the scene")
        ->group(group);
    flag("--no-panel", settings.panel, false, "begin without the panel (Tab shows it)");
    flag("--keys", settings.help, true, "begin with the help (F1)");
    flag("--marks", settings.gizmos, true, "begin with the cube maps marked (G)");
    command.add_option("--folder", settings.folder, "where keys save screenshots and cases [.]")
        ->type_name("FOLDER")
        ->group(group);
}

void attachScripting(CLI::App& command, viewer::ViewerSettings& settings) {
    const char* const group = "For scripts";
    addWholeNumber(
        command, "--frames", 1, kMostFrames, [&](int frames) { settings.frames = frames; },
        "end after so many frames")
        ->group(group);
    command
        .add_flag("--settle", settings.settle,
                  "end when nothing is left to compute, the truth included where it is shown")
        ->group(group);
    command
        .add_option("--screenshot", settings.screenshot, "what the window shows at the end, .png")
        ->type_name("FILE")
        ->group(group);
    command
        .add_option("--state", settings.stateFile,
                    "keep the state of camera, options and measurements here, .json")
        ->type_name("FILE")
        ->group(group);
    command
        .add_flag("--gl-debug", settings.strict,
                  "take any message of the driver above notification as a failure (exit code 3)")
        ->group(group);
}

} // namespace

void addViewCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<ViewCommandFlags>();
    CLI::App* command = program.add_subcommand(
        "view", "show a scene in a window: cameras, sliders for all options, comparisons");
    flags->view.attach(*command, {"town", kWidth, kHeight});
    attachWindow(*command, flags->settings);
    flags->options.attach(*command);
    attachScripting(*command, flags->settings);
    command->footer(
        "Examples:\n"
        "  aolib view                               a generated scene; drop models on it\n"
        "  aolib view model.glb --compare truth     beside its ray-traced picture\n"
        "  aolib view --case case.json --walk\n"
        "  aolib view room --settle --screenshot room.png\n"
        "F1 in the window shows all keys.");
    command->callback([flags, &failure] { failure = show(*flags); });
}

} // namespace aolib::app
