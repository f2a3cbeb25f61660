#include "app/Commands.h"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/Comparison.h"
#include "app/GlSession.h"
#include "app/LitRender.h"
#include "app/NumberFlags.h"
#include "app/OptionFlags.h"
#include "app/Progress.h"
#include "app/RenderJob.h"
#include "app/RenderOutputs.h"
#include "app/ResolveOptions.h"
#include "app/ResultTable.h"
#include "app/UnusedOptions.h"
#include "app/ViewFlags.h"

namespace aolib::app {

namespace {

constexpr int kMostFrames = 100000;
constexpr int kMostSamples = 64;

struct RenderFlags {
    ViewFlags view;
    OptionFlags options;
    GlFlags gl;
    RenderOutputs outputs;
    LitFlags lit;
    std::vector<glm::vec3> cubeMaps;
    int frames = 3;
    int samples = 0;
    std::optional<int> rays;
};

RenderJob jobOf(const RenderFlags& flags, const View& view) {
    RenderJob job;
    job.camera = view.camera;
    job.width = view.width;
    job.height = view.height;
    job.samples = flags.samples;
    job.options = resolveOptions(view, flags.options);
    if (!flags.cubeMaps.empty() && !flags.options.given("place")) {
        job.options.cubeMaps.place = false;
    }
    job.normals = view.normals;
    job.cubeMaps = flags.cubeMaps;
    job.frames = flags.frames;
    job.debugViews = flags.outputs.debugViews();
    return job;
}

void report(const std::string& device, const View& view, const RenderJob& job,
            const RenderResult& result, const std::optional<ErrorAgainstTruth>& error,
            const std::vector<std::filesystem::path>& files) {
    ResultTable table;
    table.add(view.model.name, view.model.triangleCount(), result, error);
    std::cout << device << '\n'
              << job.width << " x " << job.height << " pixels, radius " << job.options.radius
              << " world units\n"
              << table.text() << ResultTable::kFrames;
    if (error) {
        std::cout << "RMSE and bias of W against ray tracing with " << error->rays
                  << " rays per pixel\n";
    }
    for (const std::filesystem::path& file : files) {
        std::cout << "wrote " << file.string() << '\n';
    }
}

MaybeFailure run(RenderFlags& flags) {
    if (flags.lit.given()) {
        std::vector<std::string> unused;
        for (const std::string& name : flags.options.given()) {
            unused.push_back("--" + name +
                             " has no effect: light from an environment map has its own");
        }
        warnOf(unused);
        return renderLit(flags.lit, flags.view, flags.gl);
    }
    const bool withTruth = flags.rays.has_value() || flags.outputs.needTruth();
    if (MaybeFailure failure = flags.outputs.announce(withTruth)) {
        return failure;
    }
    Progress progress;
    progress.begin("opening the scene");
    const Result<View, Failure> view = flags.view.open();
    if (!view) {
        return view.error();
    }
    progress.pause();
    const RenderJob job = jobOf(flags, *view);
    const Result<GlSession, Failure> session = GlSession::open(flags.gl);
    if (!session) {
        return session.error();
    }
    const Result<RenderResult, Failure> result = render(*session, view->model, job, progress);
    if (!result) {
        return result.error();
    }
    if (MaybeFailure failure = session->reviewMessages()) {
        return failure;
    }
    warnOf(unusedOptions(flags.options, job.options));
    std::optional<Truth> truth;
    std::optional<ErrorAgainstTruth> error;
    if (withTruth) {
        Result<Truth, Failure> traced =
            traceTruth(*view, job.options, flags.rays.value_or(kDefaultRays), progress);
        if (!traced) {
            return traced.error();
        }
        const Result<ErrorAgainstTruth, Failure> compared =
            compareWithTruth(result->visibility, *traced);
        if (!compared) {
            return compared.error();
        }
        truth = std::move(*traced);
        error = *compared;
    }
    if (MaybeFailure failure = flags.outputs.write(*result, truth)) {
        return failure;
    }
    report(session->describe(), *view, job, *result, error, flags.outputs.written());
    return std::nullopt;
}

} // namespace

void addRenderCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<RenderFlags>();
    CLI::App* command = program.add_subcommand(
        "render", "render a scene with ambient occlusion, write pictures, print numbers");
    flags->view.attach(*command);
    flags->options.attach(*command);
    flags->outputs.attach(*command);
    flags->lit.attach(*command);
    flags->gl.attach(*command);
    addVector(
        *command, "--cube-map",
        [flags](const glm::vec3& position) { flags->cubeMaps.push_back(position); },
        "place a cube map here, world units; may be repeated. Without it they are placed by "
        "coverage, the first at the eye");
    addWholeNumber(
        *command, "--frames", 1, kMostFrames, [flags](int frames) { flags->frames = frames; },
        "frames drawn before the picture is taken; then a few more are timed")
        ->default_str(std::to_string(flags->frames));
    addWholeNumber(
        *command, "--samples", 0, kMostSamples, [flags](int samples) { flags->samples = samples; },
        "samples per pixel of the host's framebuffer")
        ->default_str(std::to_string(flags->samples));
    addWholeNumber(
        *command, "--truth-rays", 2, kMostRays, [flags](int rays) { flags->rays = rays; },
        "trace the truth with so many rays per pixel and print the error; --truth and "
        "--difference alone take " +
            std::to_string(kDefaultRays))
        ->type_name("RAYS");
    command->footer(
        "Examples:\n"
        "  aolib render town -o out                            all pictures, default camera\n"
        "  aolib render bunny.glb --radius 5% --composite bunny.png\n"
        "  aolib render room --camera corner --debug quality=quality.png\n"
        "  aolib render town --cube-map 0,3,0 --cube-map 8,3,-4 --ao w.pfm\n"
        "  aolib render --case case.json --ao w.pfm --truth-rays 256\n"
        "  aolib render town --environment sunny --lit town.png\n"
        "automatic is ray-traced, or layered-intervals in screen space.\n"
        "Times are wall clock, with the GPU's work done.");
    command->callback([flags, &failure] { failure = run(*flags); });
}

} // namespace aolib::app
