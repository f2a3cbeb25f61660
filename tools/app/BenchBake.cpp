#include "app/BenchBake.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/BakeInput.h"
#include "app/BakePlan.h"
#include "app/BenchOutput.h"
#include "app/GlSession.h"
#include "app/Interruption.h"
#include "app/NumberFlags.h"
#include "app/ParseValues.h"
#include "bench/MachineInfo.h"
#include "bench/TextFile.h"
#include "bench/bake/BakeGrowth.h"
#include "bench/bake/BakeTable.h"
#include "bench/bake/VertexRun.h"
#include "bench/plot/PlotFiles.h"
#include "content/FileBytes.h"
#include "content/generated/UvShapes.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

/// The numbers of triangles in McGraw and Sowers 2008, table 1.
constexpr int kPaperSizes[] = {14998, 20088, 63012, 84638, 290656, 588032, 654666};
constexpr int kQuickSizes[] = {6036, 63012, 654666};

struct BenchBakeFlags {
    GlFlags gl;
    std::vector<std::string> meshes;
    std::vector<bench::BakeMethodName> methods;
    std::vector<int> samples;
    int size = 0;
    int truthRays = 4096;
    int truthTexels = 0;
    int repeats = 1;
    bool vertices = false;
    bool quick = false;
    bool resume = false;
    std::string out = "out/bake";
};

/// "bumps-20088", a shape, or a model; for maps of one material.
Result<bench::BakeMesh, Failure> meshOf(const std::string& name, int mapSize, bool vertices) {
    bench::BakeMesh mesh;
    mesh.name = name;
    const std::string bumps = "bumps-";
    if (name.rfind(bumps, 0) == 0) {
        const std::optional<double> count = parseNumber(name.substr(bumps.size()));
        if (!count || *count < 100.0 || *count > 2e7) {
            return badInput("--mesh " + name + ": bumps-N with N from 100 to 20 000 000 is needed");
        }
        const UvMesh made = bumpySphere(static_cast<int>(*count));
        mesh.triangles = made.indices.size() / 3;
        mesh.scene.surfaces.push_back({made.positions, made.normals, made.uvs, made.indices, 0});
        return mesh;
    }
    Result<BakeInput, Failure> input = openBakeInput(name);
    if (!input) {
        return input.error();
    }
    if (!vertices) {
        BakeFlags flags;
        flags.map.width = flags.map.height = mapSize;
        const Result<std::vector<PlannedMap>, Failure> maps = planMaps(*input, flags);
        if (!maps) {
            return maps.error();
        }
        if (maps->size() > 1) {
            return badInput("--mesh " + name + ": it has " + std::to_string(maps->size()) +
                            " materials, and the bench takes models of one");
        }
    }
    mesh.name = input->name;
    for (const BakePiece& piece : input->pieces) {
        mesh.scene.surfaces.push_back(piece.surface);
        mesh.triangles += piece.surface.indices.size() / 3;
    }
    return mesh;
}

Result<bench::BakePlan, Failure> planOf(const BenchBakeFlags& flags) {
    using Method = bench::BakeMethodName;
    bench::BakePlan plan;
    plan.mapSize = flags.size > 0 ? flags.size : (flags.quick ? 128 : 512);
    plan.truthRays = flags.truthRays;
    plan.truthTexels = flags.truthTexels;
    plan.repeats = flags.repeats;
    plan.methods = flags.methods.empty()
                       ? std::vector<Method>{Method::Rays, Method::Scatter, Method::Shadow}
                       : flags.methods;
    plan.samples = flags.samples;
    if (plan.samples.empty()) {
        plan.samples = flags.quick ? std::vector<int>{32, 64} : std::vector<int>{512, 1024};
    }
    std::vector<std::string> names = flags.meshes;
    if (names.empty()) {
        const std::span<const int> sizes =
            flags.quick ? std::span<const int>(kQuickSizes) : std::span<const int>(kPaperSizes);
        for (const int size : sizes) {
            names.push_back("bumps-" + std::to_string(size));
        }
    }
    for (const std::string& name : names) {
        Result<bench::BakeMesh, Failure> mesh = meshOf(name, plan.mapSize, flags.vertices);
        if (!mesh) {
            return mesh.error();
        }
        plan.meshes.push_back(std::move(*mesh));
    }
    return plan;
}

MaybeFailure benchVertices(const bench::BakePlan& plan, const GlSession& session,
                           const fs::path& folder, Progress& progress) {
    const auto rows = bench::runVertexPlan(plan, session.loader(), stagesOn(progress));
    progress.pause();
    if (!rows) {
        return Failure{ExitCode::Failed, rows.status().message()};
    }
    for (const std::string& reason :
         {bench::writeText(folder / "vertices.csv", bench::vertexCsv(*rows)),
          bench::writeText(folder / "vertices.md", bench::vertexMarkdown(*rows))}) {
        if (!reason.empty()) {
            return Failure{ExitCode::Failed, reason};
        }
    }
    std::cout << bench::vertexMarkdown(*rows);
    return std::nullopt;
}

MaybeFailure benchBake(const BenchBakeFlags& flags) {
    const Interruption interruption;
    Progress progress;
    progress.begin("making the meshes");
    const Result<bench::BakePlan, Failure> plan = planOf(flags);
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
    const fs::path folder(flags.out);
    if (flags.vertices) {
        return benchVertices(*plan, *session, folder, progress);
    }
    bench::BakeMemory memory;
    if (flags.resume) {
        memory.truths = folder / "truths";
        if (const Result<std::string, LoadError> before = readFileBytes(folder / "bake.csv")) {
            memory.known = bench::rowsOfBakeCsv(*before);
        }
    }
    memory.keep = [&](const std::vector<bench::BakeRow>& rows) {
        static_cast<void>(bench::writeText(folder / "bake.csv", bench::bakeCsv(rows)));
    };
    const auto rows = bench::runBakePlan(*plan, memory, session->loader(), stagesOn(progress));
    progress.pause();
    if (!rows) {
        return Failure{ExitCode::Failed, rows.status().message()};
    }
    const bench::MachineInfo machine = bench::describeMachine(session->describe());
    const std::string where =
        machine.cpu + ", " + std::to_string(machine.cores) + " cores; " + machine.driver +
        "; truth " + std::to_string(plan->truthRays) + " rays" +
        (plan->truthTexels > 0
             ? ", at seams and " + std::to_string(plan->truthTexels) + " other texels"
             : "");
    const std::string report = where + "\n\n" + bench::bakeMarkdown(*rows) + "\n" +
                               bench::growthMarkdown(bench::growthOf(*rows));
    for (const std::string& reason :
         {bench::writeText(folder / "bake.csv", bench::bakeCsv(*rows)),
          bench::writeText(folder / "bake.md", report),
          bench::writePlot(bench::bakePlot(*rows, where), folder / "bake")}) {
        if (!reason.empty()) {
            return Failure{ExitCode::Failed, reason};
        }
    }
    std::cout << report;
    return std::nullopt;
}

} // namespace

void addBenchBake(CLI::App& bench, MaybeFailure& failure) {
    using Method = bench::BakeMethodName;
    const auto flags = std::make_shared<BenchBakeFlags>();
    CLI::App* command =
        bench.add_subcommand("bake", "time and error of the bakers over meshes of the sizes of "
                                     "McGraw and Sowers 2008, table 1");
    addTexts(*command, "--mesh", flags->meshes, "MESH",
             "bumps-N (N triangles), a shape such as uv-shapes, or a model; may be repeated");
    addChoice<Method>(
        *command, "--method",
        {{"rays", Method::Rays},
         {"scatter", Method::Scatter},
         {"scatter-unstretched", Method::ScatterUnstretched},
         {"shadow", Method::Shadow}},
        [flags](Method value) { flags->methods = {value}; }, "only this one; without it three");
    addChoice<bool>(
        *command, "--target", {{"texture", false}, {"vertex", true}},
        [flags](bool vertices) { flags->vertices = vertices; },
        "maps, or values of vertices in all ways to fit them")
        ->default_str("texture");
    addWholeNumber(
        *command, "--samples", 1, 1 << 20, [flags](int count) { flags->samples.push_back(count); },
        "rays per texel, or directions; may be repeated; without it 512 and 1024")
        ->trigger_on_parse();
    addWholeNumber(
        *command, "--size", 16, 4096, [flags](int size) { flags->size = size; },
        "texels along the map; without it 512, quick 128");
    addWholeNumber(*command, "--truth-rays", 1, kMostRays, flags->truthRays, "per texel");
    addWholeNumber(*command, "--truth-texels", 1, 1 << 24, flags->truthTexels,
                   "trace the truth at all texels at seams and at so many others, drawn by chance; "
                   "without it at all");
    addWholeNumber(*command, "--repeats", 1, kMostRepeats, flags->repeats,
                   "of each bake; the median time counts");
    command->add_flag("--quick", flags->quick, "three meshes, small maps, 32 and 64 samples");
    command->add_flag("--resume", flags->resume,
                      "measure only what the folder's bake.csv lacks; truths are kept in files");
    command->add_option("--out", flags->out, "folder for bake.csv, bake.md and the plot")
        ->type_name("FOLDER");
    flags->gl.attach(*command);
    command->footer("Examples:\n"
                    "  aolib bench bake --quick\n"
                    "  aolib bench bake --mesh uv-shapes --samples 1024 --size 256\n"
                    "  aolib bench bake --mesh uv-shapes --samples 256 --samples 512 --samples "
                    "1024 --repeats 3");
    command->callback([flags, &failure] { failure = benchBake(*flags); });
}

} // namespace aolib::app
