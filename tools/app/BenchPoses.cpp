#include "app/BenchPoses.h"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/BakeInput.h"
#include "app/Interruption.h"
#include "app/NumberFlags.h"
#include "app/Progress.h"
#include "bench/poses/PoseRun.h"
#include "content/generated/AnimatedModels.h"

namespace aolib::app {

namespace {

struct BenchPosesFlags {
    std::vector<std::string> models;
    int rays = 1024;
    int tests = 8;
    int animation = 0;
};

Result<std::vector<bench::PoseRow>, Failure>
rowsOf(const std::string& name, const BenchPosesFlags& flags, Progress& progress) {
    progress.begin(name + ": baking poses");
    const Result<BakeInput, Failure> input = openBakeInput(name);
    if (!input) {
        return input.error();
    }
    const Result<MovingGltf, LoadError> moving = MovingGltf::open(input->gltf, name);
    if (!moving) {
        return badInput(moving.error().sentence);
    }
    if (static_cast<std::size_t>(flags.animation) >= moving->animations()) {
        return badInput(name + " has " + std::to_string(moving->animations()) + " animations");
    }
    bench::PosePlan plan;
    plan.name = input->name;
    plan.model = &*moving;
    plan.animation = static_cast<std::size_t>(flags.animation);
    plan.rays = flags.rays;
    plan.tests = flags.tests;
    const auto rows = bench::runPosePlan(plan, [&](double done) {
        progress.update(done);
        return !Interruption::happened();
    });
    if (!rows) {
        return Failure{ExitCode::Failed, name + ": " + rows.status().message()};
    }
    return *rows;
}

MaybeFailure benchPoses(const BenchPosesFlags& flags) {
    const Interruption interruption;
    Progress progress;
    std::vector<bench::PoseRow> all;
    for (const std::string& name : flags.models.empty() ? animatedModelNames() : flags.models) {
        const auto rows = rowsOf(name, flags, progress);
        if (!rows) {
            return rows.error();
        }
        all.insert(all.end(), rows->begin(), rows->end());
    }
    progress.pause();
    std::cout << bench::poseMarkdown(all);
    return std::nullopt;
}

} // namespace

void addBenchPoses(CLI::App& bench, MaybeFailure& failure) {
    const auto flags = std::make_shared<BenchPosesFlags>();
    CLI::App* command = bench.add_subcommand(
        "poses", "error of vertices' visibility between baked poses, against fresh bakes");
    addTexts(*command, "--model", flags->models, "MODEL",
             "a glTF with animations, or arm, hinge, bellows; may be repeated. Without it those "
             "three");
    addWholeNumber(*command, "--rays", 1, kMostRays, flags->rays, "per vertex");
    addWholeNumber(*command, "--tests", 1, 1000, flags->tests, "times that are compared");
    addWholeNumber(*command, "--animation", 0, 100000, flags->animation,
                   "which one, by its number in the file");
    command->footer("Examples:\n"
                    "  aolib bench poses\n"
                    "  aolib bench poses --model fox.glb --animation 1");
    command->callback([flags, &failure] { failure = benchPoses(*flags); });
}

} // namespace aolib::app
