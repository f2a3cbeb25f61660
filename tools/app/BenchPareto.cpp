#include "app/BenchPareto.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/BenchOutput.h"
#include "app/CommandLineText.h"
#include "app/GlSession.h"
#include "app/NumberFlags.h"
#include "app/ParetoReport.h"
#include "app/ParseValues.h"
#include "bench/CaseTable.h"
#include "bench/MethodTable.h"
#include "bench/ParetoFiles.h"
#include "bench/ParetoPlots.h"
#include "bench/ParetoRun.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

constexpr int kMostTimedFrames = 1000;
constexpr int kMostStride = 64;
constexpr int kMostSide = 16384;
constexpr int kQuickRays = 128;

struct ParetoFlags {
    GlFlags gl;
    std::vector<std::string> scenes;
    std::vector<std::string> methods;
    std::vector<std::string> cameras;
    std::vector<double> radii; ///< shares of the diagonal
    bool quick = false;
    bool list = false;
    std::optional<int> width;
    std::optional<int> height;
    std::optional<int> rays;
    bench::TruthSettings truth;
    bench::TimingSettings timing;
    std::string out = "out/pareto";
    std::string cache;
};

bool allows(const std::vector<std::string>& chosen, const std::string& name) {
    return chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end();
}

Result<std::vector<bench::BenchCase>, Failure> chooseCases(const ParetoFlags& flags) {
    const std::vector<bench::BenchScene>& scenes = bench::benchScenes();
    for (const std::string& name : flags.scenes) {
        const bool known = std::any_of(scenes.begin(), scenes.end(),
                                       [&](const bench::BenchScene& s) { return s.name == name; });
        if (!known) {
            return badInput("--scene " + name + ": no scene of the bench; --list shows them");
        }
    }
    std::vector<bench::BenchCase> chosen;
    for (bench::BenchCase which : bench::benchCases()) {
        if (!allows(flags.scenes, which.scene.name) ||
            !allows(flags.cameras, std::to_string(which.camera + 1))) {
            continue;
        }
        if (flags.radii.empty()) {
            chosen.push_back(which);
        } else if (which.radiusShare == bench::kWideRadius) {
            for (const double radius : flags.radii) {
                which.radiusShare = radius;
                chosen.push_back(which);
            }
        }
    }
    return chosen;
}

Result<std::vector<bench::Method>, Failure> chooseMethods(const ParetoFlags& flags) {
    const std::vector<bench::Method>& all = bench::benchMethods();
    for (const std::string& pattern : flags.methods) {
        const bool known = std::any_of(all.begin(), all.end(), [&](const bench::Method& m) {
            return bench::matches(pattern, m.name);
        });
        if (!known) {
            return badInput("--method " + pattern +
                            ": no method has such a name; --list shows them");
        }
    }
    return bench::chooseMethods(flags.methods);
}

Result<bench::ParetoSettings, Failure> settingsOf(const ParetoFlags& flags) {
    bench::ParetoSettings settings;
    Result<std::vector<bench::BenchCase>, Failure> cases = chooseCases(flags);
    if (!cases) {
        return cases.error();
    }
    Result<std::vector<bench::Method>, Failure> methods = chooseMethods(flags);
    if (!methods) {
        return methods.error();
    }
    settings.cases = std::move(*cases);
    settings.methods = std::move(*methods);
    settings.truth = flags.truth;
    if (flags.quick) {
        settings.truth.size = kQuickSize;
        settings.truth.rays = kQuickRays;
    }
    settings.truth.size.width = flags.width.value_or(settings.truth.size.width);
    settings.truth.size.height = flags.height.value_or(settings.truth.size.height);
    settings.truth.rays = flags.rays.value_or(settings.truth.rays);
    settings.timing = flags.timing;
    settings.out = flags.out;
    settings.cache = flags.cache.empty() ? settings.out / "truth" : fs::path(flags.cache);
    if (MaybeFailure failure = makeOutFolder(flags.out)) {
        return *failure;
    }
    return settings;
}

/// Everything that is known so far: an interrupted run keeps it.
std::string writeAll(const bench::ParetoSettings& settings,
                     const std::vector<bench::ParetoRow>& rows) {
    std::string reason = bench::writeParetoFiles(settings, rows);
    for (const auto write : {bench::writeCasePlots, bench::writeMeanPlots}) {
        reason = reason.empty() ? write(settings, rows) : reason;
    }
    return reason;
}

MaybeFailure run(const ParetoFlags& flags, const std::string& line) {
    if (flags.list) {
        printLists();
        return std::nullopt;
    }
    Result<bench::ParetoSettings, Failure> settings = settingsOf(flags);
    if (!settings) {
        return settings.error();
    }
    const Result<GlSession, Failure> session = GlSession::open(flags.gl);
    if (!session) {
        return session.error();
    }
    settings->machine = bench::describeMachine(session->describe());
    settings->commandLine = line;
    std::cout << session->describe() << '\n'
              << settings->cases.size() << " cases, " << settings->methods.size() << " methods, "
              << settings->truth.size.width << " x " << settings->truth.size.height
              << " pixels, truth with " << settings->truth.rays << " rays per point\n";
    Progress progress;
    bench::ParetoReports reports;
    showOn(progress, reports);
    reports.caseDone = [&](const std::vector<bench::ParetoRow>& rows) {
        return writeAll(*settings, rows);
    };
    const Result<std::vector<bench::ParetoRow>, LoadError> rows =
        bench::runPareto(session->gl(), session->loader(), *settings, reports);
    progress.pause();
    if (!rows) {
        return Failure{ExitCode::Failed, rows.error().sentence};
    }
    if (MaybeFailure failure = session->reviewMessages()) {
        return failure;
    }
    printSummary(*rows);
    if (flags.timing.passes) {
        printPasses(*rows);
    }
    std::cout << "wrote " << (settings->out / "pareto.csv").string() << " and pareto.json\n";
    return std::nullopt;
}

void attachSelection(CLI::App& command, ParetoFlags& flags) {
    command.add_option("--scene", flags.scenes, "only this scene; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--method", flags.methods,
                    "only methods of this name, with * and ?; may be repeated. It also reaches "
                    "those that are not run by default")
        ->type_name("PATTERN")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("--camera", flags.cameras, "only this camera, 1 or 2; may be repeated")
        ->check(CLI::IsMember({"1", "2"}))
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    const auto takeRadius = [&flags](const std::string& text) {
        const std::optional<Length> length = parseLength(text);
        if (!length || !length->relative || length->value <= 0.0) {
            throw CLI::ValidationError("--radius " + text +
                                       ": a share of the scene's diagonal is needed, such as 10%");
        }
        flags.radii.push_back(length->value);
    };
    command
        .add_option_function<std::string>(
            "--radius", takeRadius,
            "reach of occluders in place of 10% and 2% of the scene's diagonal; may be repeated")
        ->type_name("SHARE")
        ->trigger_on_parse();
    command.add_flag("--list", flags.list, "list the scenes and the methods, and do nothing");
}

void attachEffort(CLI::App& command, ParetoFlags& flags) {
    command.add_flag("--quick", flags.quick, "pictures of 320 x 180, truth with 128 rays");
    command.add_flag("--passes", flags.timing.passes,
                     "also time every pass of a frame and of a build (aolib's methods)");
    addWholeNumber(
        command, "--width", 1, kMostSide, [&flags](int n) { flags.width = n; }, "pixels")
        ->default_str("960");
    addWholeNumber(
        command, "--height", 1, kMostSide, [&flags](int n) { flags.height = n; }, "pixels")
        ->default_str("540");
    addWholeNumber(
        command, "--rays", 2, kMostRays, [&flags](int n) { flags.rays = n; },
        "of the truth, per point")
        ->default_str("512");
    addWholeNumber(
        command, "--stride", 1, kMostStride, [&flags](int n) { flags.truth.stride = n; },
        "the truth is traced at one pixel in each cell of so many by so many")
        ->default_str("3");
    addWholeNumber(
        command, "--repeat", 1, kMostRepeats, [&flags](int n) { flags.timing.repeat = n; },
        "builds per method and case, of which the median is told")
        ->default_str("1");
    addWholeNumber(
        command, "--build-seconds", 1, kMostBuildSeconds,
        [&flags](int n) { flags.timing.buildSeconds = n; },
        "a build that has not converged by then is taken as it is")
        ->default_str("600");
    addWholeNumber(
        command, "--frames", 1, kMostTimedFrames, [&flags](int n) { flags.timing.frames = n; },
        "timed after each build")
        ->default_str("7");
}

} // namespace

void addBenchPareto(CLI::App& bench, MaybeFailure& failure) {
    const auto flags = std::make_shared<ParetoFlags>();
    CLI::App* pareto = bench.add_subcommand(
        "pareto", "error against cost: every method over every case, tables and plots");
    attachSelection(*pareto, *flags);
    attachEffort(*pareto, *flags);
    pareto->add_option("--out", flags->out, "folder for what is written")->type_name("DIR");
    pareto
        ->add_option("--cache", flags->cache,
                     "folder of traced truths; they are traced once and kept. Without it \"truth\" "
                     "in the output folder")
        ->type_name("DIR");
    flags->gl.attach(*pareto);
    pareto->footer(
        "A case is a scene, a camera and a radius. Absent models are left out with a warning.\n"
        "Results are written after every case. All 36 truths take about 2 minutes on two idle\n"
        "cores; all default methods take hours on a software rasteriser: choose.\n"
        "Examples:\n"
        "  aolib bench pareto --quick --scene town --method 'layered-*'\n"
        "  aolib bench pareto --repeat 3 --out out/pareto");
    pareto->callback(
        [flags, pareto, &failure] { failure = run(*flags, commandLineText(*pareto)); });
}

} // namespace aolib::app
