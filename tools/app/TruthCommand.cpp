#include "app/Commands.h"

#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/NumberFlags.h"
#include "app/OutputFiles.h"
#include "app/Progress.h"
#include "app/ResolveOptions.h"
#include "app/Table.h"
#include "app/TruthJob.h"
#include "app/ViewFlags.h"

namespace aolib::app {

namespace {

struct TruthCommandFlags {
    ViewFlags view;
    OptionFlags options;
    int rays = kDefaultRays;
    std::string out;
    std::string error;
};

MaybeFailure trace(const TruthCommandFlags& flags) {
    OutputFiles files;
    if (MaybeFailure failure = files.announce("--out", flags.out, {".pfm", ".png"})) {
        return failure;
    }
    if (!flags.error.empty()) {
        if (MaybeFailure failure = files.announce("--error", flags.error, {".pfm"})) {
            return failure;
        }
    }
    Progress progress;
    progress.begin("opening the scene");
    const Result<View, Failure> view = flags.view.open();
    if (!view) {
        return view.error();
    }
    const Options options = resolveOptions(*view, flags.options);
    const Result<Truth, Failure> truth = traceTruth(*view, options, flags.rays, progress);
    if (!truth) {
        return truth.error();
    }
    files.put(flags.out, truth->visibility);
    if (!flags.error.empty()) {
        files.put(flags.error, truth->standardError);
    }
    if (MaybeFailure failure = files.commit()) {
        return failure;
    }
    std::cout << flags.out << ": " << truth->rays << " rays per pixel, radius " << options.radius
              << ", expected RMSE of the noise " << knownNumber(truth->noise, 4) << '\n';
    return std::nullopt;
}

} // namespace

void addTruthCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<TruthCommandFlags>();
    CLI::App* command =
        program.add_subcommand("truth", "trace W with rays, without OpenGL, and write it");
    flags->view.attach(*command);
    flags->options.attach(*command, {"radius", "falloff"});
    addWholeNumber(
        *command, "--rays", 2, kMostRays, [flags](int rays) { flags->rays = rays; },
        "rays per pixel")
        ->default_str(std::to_string(kDefaultRays));
    command->add_option("-o,--out", flags->out, "picture of W, .pfm (background -1) or .png")
        ->type_name("FILE")
        ->required();
    command->add_option("--error", flags->error, "the standard error of each pixel, .pfm")
        ->type_name("FILE");
    command->footer("Examples:\n"
                    "  aolib truth room --radius 10% --rays 1024 --out t.pfm\n"
                    "  aolib truth --case case.json --out t.pfm\n"
                    "The noise falls with the root of the number of rays.");
    command->callback([flags, &failure] { failure = trace(*flags); });
}

} // namespace aolib::app
