#include "app/Commands.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/Comparison.h"
#include "app/GlSession.h"
#include "app/NumberFlags.h"
#include "app/OptionFlags.h"
#include "app/OutputFiles.h"
#include "app/Progress.h"
#include "app/RenderJob.h"
#include "app/ResolveOptions.h"
#include "app/ResultTable.h"
#include "app/UnusedOptions.h"
#include "content/SceneSource.h"
#include "image/Compose.h"
#include "image/FalseColour.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

/// The generated scenes of the demo; models follow.
constexpr std::array kScenes{"town", "room", "dome"};
/// Sizes that keep the whole demo to a few minutes on two cores without a graphics card.
constexpr int kWidth = 960;
constexpr int kHeight = 540;
constexpr int kDemoRays = 128;
constexpr int kMostPixels = 4096;

struct DemoFlags {
    OptionFlags options;
    GlFlags gl;
    std::string out = "out";
    std::string models;
    int rays = kDemoRays;
    int width = kWidth;
    int height = kHeight;
};

/// One scene of the demo, done.
struct DemoRow {
    std::string name;
    std::size_t triangles = 0;
    RenderResult result;
    ErrorAgainstTruth error;
};

/// Generated scenes and models, each name once: a bunny.glb makes a bunny.obj superfluous.
Result<std::vector<std::string>, Failure> findScenes(const DemoFlags& flags) {
    std::vector<std::string> scenes(kScenes.begin(), kScenes.end());
    std::set<std::string> names(scenes.begin(), scenes.end());
    std::error_code ignored;
    if (!flags.models.empty() && !fs::is_directory(flags.models, ignored)) {
        return badInput("--models " + flags.models + ": there is no such folder");
    }
    const std::vector<fs::path> models =
        flags.models.empty() ? availableModels() : findModels(flags.models);
    for (const fs::path& model : models) {
        if (names.insert(model.stem().string()).second) {
            scenes.push_back(model.string());
        }
    }
    return scenes;
}

/// The picture without AO, W, what both give, the truth, and the difference, beside each other.
Result<ByteImage, Failure> contactStrip(const RenderResult& result, const Truth& truth,
                                        const ByteImage& difference) {
    const std::array<ByteImage, 5> pictures{result.colour, greyPicture(result.visibility),
                                            result.composite, greyPicture(truth.visibility),
                                            difference};
    Result<ByteImage, ImageError> strip = sideBySide(pictures);
    if (!strip) {
        return Failure{ExitCode::Failed, "contact strip: " + strip.error().message};
    }
    return std::move(*strip);
}

MaybeFailure writePictures(const std::string& folder, const std::string& name,
                           const RenderResult& result, const Truth& truth) {
    const Result<ByteImage, Failure> difference = differenceFromTruth(result.visibility, truth);
    if (!difference) {
        return difference.error();
    }
    const Result<ByteImage, Failure> strip = contactStrip(result, truth, *difference);
    if (!strip) {
        return strip.error();
    }
    OutputFiles files;
    if (MaybeFailure failure = files.createFolder("--out", folder)) {
        return failure;
    }
    const fs::path base = fs::path(folder) / name;
    const auto named = [&](const char* ending) { return fs::path(base.string() + ending); };
    files.put(named("-colour.png"), result.colour);
    files.put(named("-ao.png"), result.visibility);
    files.put(named("-composite.png"), result.composite);
    files.put(named("-truth.png"), truth.visibility);
    files.put(named("-difference.png"), *difference);
    files.put(named(".png"), *strip);
    return files.commit();
}

Result<DemoRow, Failure> showScene(const DemoFlags& flags, const GlSession& session,
                                   const std::string& scene, Progress& progress) {
    progress.begin(fs::path(scene).filename().string() + ": opening");
    Result<Model, LoadError> model = openScene(scene);
    if (!model) {
        return badInput(model.error().sentence);
    }
    View view;
    view.model = std::move(*model);
    view.diagonal = static_cast<double>(view.model.bounds().diagonal());
    view.camera = camerasFor(scene, view.model).front();
    view.width = flags.width;
    view.height = flags.height;
    RenderJob job;
    job.camera = view.camera;
    job.width = view.width;
    job.height = view.height;
    job.normals = view.normals;
    job.options = resolveOptions(view, flags.options);
    if (scene == kScenes.front()) { // the same for all
        warnOf(unusedOptions(flags.options, job.options));
    }
    Result<RenderResult, Failure> result = render(session, view.model, job, progress);
    if (!result) {
        return result.error();
    }
    const Result<Truth, Failure> truth = traceTruth(view, job.options, flags.rays, progress);
    if (!truth) {
        return truth.error();
    }
    const Result<ErrorAgainstTruth, Failure> error = compareWithTruth(result->visibility, *truth);
    if (!error) {
        return error.error();
    }
    if (MaybeFailure failure = writePictures(flags.out, view.model.name, *result, *truth)) {
        return *failure;
    }
    return DemoRow{view.model.name, view.model.triangleCount(), std::move(*result), *error};
}

void report(const DemoFlags& flags, const std::vector<DemoRow>& rows) {
    if (rows.empty()) {
        return;
    }
    ResultTable table;
    for (const DemoRow& row : rows) {
        table.add(row.name, row.triangles, row.result, row.error);
    }
    std::cout << '\n'
              << table.text() << ResultTable::kFrames << '\n'
              << flags.width << " x " << flags.height
              << " pixels. RMSE and bias are of visibility W against ray tracing with "
              << rows.front().error.rays
              << " rays per pixel;\n\"truth noise\" is the RMSE that those few rays cause by "
                 "themselves.\nPictures: "
              << flags.out << "/SCENE.png (colour, AO, composite, truth, difference) and each of "
              << "them alone\n";
}

MaybeFailure demo(const DemoFlags& flags) {
    const Result<std::vector<std::string>, Failure> scenes = findScenes(flags);
    if (!scenes) {
        return scenes.error();
    }
    OutputFiles check;
    if (MaybeFailure failure = check.createFolder("--out", flags.out)) {
        return failure;
    }
    const Result<GlSession, Failure> session = GlSession::open(flags.gl);
    if (!session) {
        return session.error();
    }
    std::cout << session->describe() << std::endl;
    if (scenes->size() == kScenes.size()) {
        std::cout << "no models found; AOLIB_MODELS_DIR or --models names a folder that has some\n";
    }
    Progress progress;
    std::vector<DemoRow> rows;
    std::vector<Failure> failures;
    for (std::size_t i = 0; i < scenes->size(); ++i) {
        Result<DemoRow, Failure> row = showScene(flags, *session, (*scenes)[i], progress);
        progress.pause();
        if (row) {
            rows.push_back(std::move(*row));
        } else {
            failures.push_back(row.error());
        }
        const std::string count =
            "[" + std::to_string(i + 1) + "/" + std::to_string(scenes->size()) + "] ";
        std::cerr << count << (row ? rows.back().name + " done" : failures.back().sentence)
                  << std::endl;
    }
    report(flags, rows);
    if (MaybeFailure failure = session->reviewMessages()) {
        return failure;
    }
    return failures.empty() ? std::nullopt : MaybeFailure(failures.front());
}

} // namespace

void addDemoCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<DemoFlags>();
    CLI::App* command = program.add_subcommand(
        "demo", "render generated scenes and all models found, and compare with ray tracing");
    command->add_option("-o,--out", flags->out, "folder for the pictures, made if missing")
        ->type_name("FOLDER")
        ->default_str(flags->out);
    command
        ->add_option("--models", flags->models,
                     "folder of .glb, .gltf and .obj files; else AOLIB_MODELS_DIR")
        ->type_name("FOLDER");
    const auto number = [&](const char* flag, int& into, int min, int max, const char* help) {
        addWholeNumber(
            *command, flag, min, max, [&into](int value) { into = value; }, help)
            ->default_str(std::to_string(into));
    };
    number("--rays", flags->rays, 2, kMostRays, "rays per pixel of the truth");
    number("--width", flags->width, 1, kMostPixels, "width of the pictures");
    number("--height", flags->height, 1, kMostPixels, "height of the pictures");
    flags->options.attach(*command);
    flags->gl.attach(*command);
    command->footer("Without --estimator: ray-traced.\n"
                    "Examples:\n"
                    "  aolib demo --out out\n"
                    "  aolib demo --out out --models ~/models --rays 256 --radius 5%");
    command->callback([flags, &failure] { failure = demo(*flags); });
}

} // namespace aolib::app
