#include "app/BenchEnvironment.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/BenchOutput.h"
#include "app/GlSession.h"
#include "app/Interruption.h"
#include "app/NumberFlags.h"
#include "bench/MachineInfo.h"
#include "bench/TextFile.h"
#include "bench/environment/EnvironmentTable.h"
#include "content/EnvironmentSource.h"
#include "content/SceneSource.h"
#include "content/generated/Environments.h"
#include "content/generated/GeneratedScenes.h"
#include "image/Png.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

struct BenchEnvironmentFlags {
    GlFlags gl;
    std::vector<std::string> scenes;
    std::vector<std::string> environments;
    int width = 320;
    int truthRays = 1024;
    bool quick = false;
    std::string out = "out/environment";
};

/// The file of a model that is known by its stem, or the name itself.
std::string sourceOf(const std::string& name) {
    for (const fs::path& file : availableModels()) {
        if (file.stem() == name) {
            return file.string();
        }
    }
    return name;
}

Result<bench::EnvironmentView, Failure> viewOf(const std::string& name, bool quick,
                                               Progress& progress) {
    const std::string source = sourceOf(name);
    progress.begin(name + ": baking its vertices");
    Result<Model, LoadError> model = openScene(source);
    if (!model) {
        return badInput(model.error().sentence);
    }
    const std::vector<NamedCamera> cameras = camerasFor(source, *model);
    bench::LitSceneOptions options;
    options.ground = findGeneratedScene(source) == nullptr;
    if (quick) {
        options.edge = 0.02;
        options.rays = 64;
    }
    const auto goOn = [&](double done) {
        progress.update(done);
        return !Interruption::happened();
    };
    Result<bench::LitScene> scene = bench::bakeLitScene(std::move(*model), options, goOn);
    if (!scene) {
        return Failure{ExitCode::Failed, name + ": " + scene.status().message()};
    }
    scene->name = name;
    return bench::EnvironmentView{std::move(*scene), cameras.front()};
}

Result<bench::EnvironmentPlan, Failure> planOf(const BenchEnvironmentFlags& flags,
                                               Progress& progress) {
    bench::EnvironmentPlan plan;
    plan.width = flags.quick ? 96 : flags.width;
    plan.height = plan.width * 9 / 16;
    plan.truthRays = flags.quick ? 64 : flags.truthRays;
    plan.openingRays = flags.quick ? 64 : 1024;
    std::vector<std::string> environments = flags.environments;
    if (environments.empty()) {
        for (const GeneratedEnvironment& environment : generatedEnvironments()) {
            environments.emplace_back(environment.name);
        }
    }
    for (const std::string& name : environments) {
        Result<lighting::EnvironmentMap, LoadError> map = openEnvironment(name);
        if (!map) {
            return badInput(map.error().sentence);
        }
        plan.environments.push_back({fs::path(name).stem().string(), std::move(*map)});
    }
    std::vector<std::string> scenes = flags.scenes;
    if (scenes.empty()) {
        scenes = flags.quick ? std::vector<std::string>{"cornell"}
                             : std::vector<std::string>{"town", "bunny", "flight_helmet"};
    }
    for (const std::string& name : scenes) {
        Result<bench::EnvironmentView, Failure> view = viewOf(name, flags.quick, progress);
        if (!view) {
            return view.error();
        }
        plan.views.push_back(std::move(*view));
    }
    return plan;
}

MaybeFailure writeAll(const bench::EnvironmentFigures& figures, const fs::path& folder,
                      const std::string& text) {
    for (const std::string& reason :
         {bench::writeText(folder / "environment.csv", bench::environmentCsv(figures.rows)),
          bench::writeText(folder / "environment.md", text)}) {
        if (!reason.empty()) {
            return Failure{ExitCode::Failed, reason};
        }
    }
    for (const bench::EnvironmentStrip& strip : figures.strips) {
        const fs::path file = folder / (strip.scene + "-" + strip.environment + ".png");
        if (const ImageOutcome error = writePng(file, strip.picture)) {
            return Failure{ExitCode::Failed, error->message};
        }
    }
    return std::nullopt;
}

MaybeFailure benchEnvironment(const BenchEnvironmentFlags& flags) {
    const Interruption interruption;
    Progress progress;
    const Result<bench::EnvironmentPlan, Failure> plan = planOf(flags, progress);
    if (!plan) {
        return plan.error();
    }
    const Result<GlSession, Failure> session = GlSession::open(flags.gl);
    if (!session) {
        return session.error();
    }
    if (MaybeFailure failure = makeOutFolder(flags.out)) {
        return failure;
    }
    const auto figures =
        bench::runEnvironmentPlan(*plan, session->gl(), session->loader(), stagesOn(progress));
    progress.pause();
    if (!figures) {
        return Failure{ExitCode::Failed, figures.status().message()};
    }
    if (MaybeFailure failure = session->reviewMessages()) {
        return failure;
    }
    const bench::MachineInfo machine = bench::describeMachine(session->describe());
    std::string text =
        machine.cpu + ", " + std::to_string(machine.cores) + " cores; " + machine.driver + "; " +
        std::to_string(plan->width) + " x " + std::to_string(plan->height) + " pixels, truth " +
        std::to_string(plan->truthRays) + " rays\n\nFrom values of pixels:\n\n" +
        bench::environmentMarkdown(figures->rows, false) + "\nDrawn from values of vertices:\n\n" +
        bench::environmentMarkdown(figures->rows, true);
    if (MaybeFailure failure = writeAll(*figures, flags.out, text)) {
        return failure;
    }
    std::cout << text;
    return std::nullopt;
}

} // namespace

void addBenchEnvironment(CLI::App& bench, MaybeFailure& failure) {
    const auto flags = std::make_shared<BenchEnvironmentFlags>();
    CLI::App* command = bench.add_subcommand(
        "environment", "error and time of environment lighting against a traced picture");
    addTexts(*command, "--scene", flags->scenes, "SCENE",
             "a model or a generated scene; may be repeated. Without it town, bunny and "
             "flight_helmet");
    addTexts(*command, "--environment", flags->environments, "ENVIRONMENT",
             "a .hdr file or a generated environment; may be repeated. Without it all generated "
             "ones");
    addWholeNumber(*command, "--width", 16, 4096, flags->width, "pixels; the height is 9/16 of it");
    addWholeNumber(*command, "--truth-rays", 8, kMostRays, flags->truthRays, "per pixel");
    command->add_flag("--quick", flags->quick, "one small scene, few rays");
    command
        ->add_option("--out", flags->out, "folder for environment.csv, environment.md and pictures")
        ->type_name("FOLDER");
    flags->gl.attach(*command);
    command->footer("Examples:\n"
                    "  aolib bench environment --quick\n"
                    "  aolib bench environment --scene town --environment sunny\n"
                    "Pictures show, left to right: traced, irradiance, blurred, cone, "
                    "cone-and-sun, sectors-and-sun.");
    command->callback([flags, &failure] { failure = benchEnvironment(*flags); });
}

} // namespace aolib::app
