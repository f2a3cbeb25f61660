#include "app/BenchThesis.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <aolib/OptionFields.h>

#include "app/BenchOutput.h"
#include "app/CommandLineText.h"
#include "app/GlSession.h"
#include "app/NumberFlags.h"
#include "app/Table.h"
#include "bench/ThesisFiles.h"
#include "bench/ThesisPlots.h"
#include "bench/ThesisRun.h"

namespace aolib::app {

namespace {

struct ThesisFlags {
    GlFlags gl;
    std::vector<std::string> scenes;
    std::vector<Estimator> estimators;
    std::vector<bench::ThesisFigure> figures;
    bool quick = false;
    bench::TimingSettings timing;
    std::string out = "out/thesis";
};

Result<std::vector<bench::BenchScene>, Failure>
chooseScenes(const std::vector<std::string>& names) {
    const std::vector<bench::BenchScene>& all = bench::benchScenes();
    std::vector<bench::BenchScene> chosen;
    for (const std::string& name : names) {
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const bench::BenchScene& s) { return s.name == name; });
        if (found == all.end()) {
            return badInput("--scene " + name +
                            ": no scene of the bench; \"aolib bench pareto --list\" shows them");
        }
        chosen.push_back(*found);
    }
    return names.empty() ? all : chosen;
}

Result<bench::ThesisRunSettings, Failure> settingsOf(const ThesisFlags& flags) {
    bench::ThesisRunSettings settings;
    Result<std::vector<bench::BenchScene>, Failure> scenes = chooseScenes(flags.scenes);
    if (!scenes) {
        return scenes.error();
    }
    settings.scenes = std::move(*scenes);
    const std::vector<Estimator> estimators =
        flags.estimators.empty() ? std::vector{Estimator::HorizonSplit} : flags.estimators;
    const std::vector<bench::ThesisFigure>& figures =
        flags.figures.empty() ? bench::thesisFigures() : flags.figures;
    for (const Estimator estimator : estimators) {
        for (const bench::ThesisFigure figure : figures) {
            for (const bench::ThesisSetting& setting :
                 bench::thesisSettings(figure, estimator, flags.quick)) {
                settings.settings.push_back(setting);
            }
        }
    }
    if (flags.quick) {
        settings.size = kQuickSize;
    }
    settings.timing = flags.timing;
    settings.out = flags.out;
    if (MaybeFailure failure = makeOutFolder(flags.out)) {
        return *failure;
    }
    return settings;
}

std::string spreadText(const bench::Spread& spread) {
    return knownNumber(spread.median, 1) + " (" + knownNumber(spread.low, 1) + "-" +
           knownNumber(spread.high, 1) + ")";
}

std::string megabytes(std::size_t bytes) {
    return knownNumber(static_cast<double>(bytes) / kMegabyte, 1);
}

void printRows(const std::vector<bench::ThesisRow>& rows) {
    Table table({"scene", "estimator", "figure", "faces", "directions", "steps", "cube maps",
                 "build ms each", "frame ms", "MB kept each", "MB temporary"});
    for (const bench::ThesisRow& row : rows) {
        const bench::ThesisSetting& s = row.setting;
        table.add({row.scene, std::string(bench::estimatorName(s.estimator)),
                   std::string(bench::figureName(s.figure)), std::to_string(s.faceSize),
                   std::to_string(s.directions), std::to_string(s.steps),
                   std::to_string(s.cubeMaps), spreadText(row.buildMs), spreadText(row.frameMs),
                   megabytes(row.bytesKept), megabytes(row.bytesCapture)});
    }
    std::cout << table.text() << "Medians with quartiles; radius 10% of the scene's diagonal.\n";
}

MaybeFailure run(const ThesisFlags& flags, const std::string& line) {
    Result<bench::ThesisRunSettings, Failure> settings = settingsOf(flags);
    if (!settings) {
        return settings.error();
    }
    const Result<GlSession, Failure> session = GlSession::open(flags.gl);
    if (!session) {
        return session.error();
    }
    settings->machine = bench::describeMachine(session->describe());
    settings->commandLine = line;
    std::cout << session->describe() << '\n';
    Progress progress;
    bench::ThesisReports reports;
    showOn(progress, reports);
    reports.sceneDone = [&](const std::vector<bench::ThesisRow>& rows) {
        std::string reason = bench::writeThesisFiles(*settings, rows);
        return reason.empty() ? bench::writeThesisPlots(*settings, rows) : reason;
    };
    const Result<std::vector<bench::ThesisRow>, LoadError> rows =
        bench::runThesis(session->gl(), session->loader(), *settings, reports);
    progress.pause();
    if (!rows) {
        return Failure{ExitCode::Failed, rows.error().sentence};
    }
    if (MaybeFailure failure = session->reviewMessages()) {
        return failure;
    }
    printRows(*rows);
    std::cout << "wrote thesis.csv, thesis.json and plots to " << settings->out.string() << '\n';
    return std::nullopt;
}

template <typename Value>
using Choices = std::vector<std::pair<std::string, Value>>;

void attach(CLI::App& command, ThesisFlags& flags) {
    command.add_option("--scene", flags.scenes, "only this scene; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    Choices<Estimator> estimators;
    for (const auto& choice : kEstimatorChoices) {
        if (choice.value != Estimator::Automatic) { // a figure is of one that it names
            estimators.emplace_back(std::string(choice.name), choice.value);
        }
    }
    addChoice<Estimator>(
        command, "--estimator", estimators,
        [&flags](Estimator estimator) { flags.estimators.push_back(estimator); },
        "in place of horizon-split, the thesis's own; may be repeated")
        ->trigger_on_parse();
    Choices<bench::ThesisFigure> figures;
    for (const bench::ThesisFigure figure : bench::thesisFigures()) {
        figures.emplace_back(std::string(bench::figureName(figure)), figure);
    }
    addChoice<bench::ThesisFigure>(
        command, "--figure", figures,
        [&flags](bench::ThesisFigure figure) { flags.figures.push_back(figure); },
        "only this figure; may be repeated")
        ->trigger_on_parse();
    command.add_flag("--quick", flags.quick, "pictures of 320 x 180, faces a quarter as wide");
    addWholeNumber(
        command, "--repeat", 1, kMostRepeats, [&flags](int n) { flags.timing.repeat = n; },
        "builds per measurement, of which the median is told")
        ->default_str(std::to_string(flags.timing.repeat));
    command.add_option("--out", flags.out, "folder for what is written")
        ->type_name("DIR")
        ->capture_default_str();
    flags.gl.attach(command);
}

} // namespace

void addBenchThesis(CLI::App& bench, MaybeFailure& failure) {
    const auto flags = std::make_shared<ThesisFlags>();
    flags->timing.repeat = 3;
    CLI::App* thesis = bench.add_subcommand(
        "thesis", "the thesis's figures: build time, frame time and memory of cube maps");
    attach(*thesis, *flags);
    thesis->footer(
        "Build time over face size (256, 512, 1024), directions and steps; frame time over 1 to\n"
        "25 cube maps; memory while a cube map is built and kept. Each scene's first camera.\n"
        "Examples:\n"
        "  aolib bench thesis --scene town --scene bunny\n"
        "  aolib bench thesis --quick --figure cube-maps --estimator layered-intervals");
    thesis->callback(
        [flags, thesis, &failure] { failure = run(*flags, commandLineText(*thesis)); });
}

} // namespace aolib::app
