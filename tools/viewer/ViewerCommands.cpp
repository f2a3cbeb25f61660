// What keys, buttons and the end of a run have the viewer do.
#include <algorithm>
#include <cctype>
#include <iostream>
#include <utility>

#include <aolib/OptionFields.h>

#include "app/OutputFiles.h"
#include "bench/TextFile.h"
#include "viewer/CaseExport.h"
#include "viewer/NumberedFiles.h"
#include "viewer/StateReport.h"
#include "viewer/Viewer.h"

namespace aolib::viewer {

namespace {

namespace fs = std::filesystem;

/// The choice after this one; after the last the first.
template <typename E, std::size_t N>
E following(E value, const std::array<OptionChoice<E>, N>& choices) {
    for (std::size_t i = 0; i < N; ++i) {
        if (choices[i].value == value) {
            return choices[(i + 1) % N].value;
        }
    }
    return choices.front().value;
}

bool isEnvironmentFile(const std::string& path) {
    std::string ending = fs::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return ending == ".hdr";
}

void toggle(bool& value) {
    value = !value;
}

} // namespace

void Viewer::execute(Command command) {
    guiFrames_ = std::max(guiFrames_, 2);
    switch (command) {
    case Command::Help:
        return toggle(state_.help);
    case Command::Panel:
        return toggle(state_.panel);
    case Command::Mode:
        state_.camera.mode =
            state_.camera.mode == CameraMode::Orbit ? CameraMode::Walk : CameraMode::Orbit;
        return messages_.tell(state_.camera.mode == CameraMode::Walk
                                  ? "walk: W A S D, Q E and the mouse"
                                  : "orbit: the mouse turns, moves and zooms");
    case Command::ResetCamera:
        return state_.camera.reset();
    case Command::NextCamera: {
        const std::vector<NamedCamera>& cameras = scene_->cameras();
        nextCamera_ = (nextCamera_ + 1) % cameras.size();
        return goToCamera(cameras[nextCamera_]);
    }
    case Command::Occlusion:
        return toggle(state_.occlusion);
    case Command::NextComparedMethod:
        state_.compared = kComparedMethods[(static_cast<std::size_t>(state_.compared) + 1) %
                                           kComparedMethods.size()]
                              .value;
        return;
    case Command::NextDebugView:
        state_.options.debugView = following(state_.options.debugView, kDebugViewChoices);
        return;
    case Command::NextBackbone:
        state_.options.backbone = following(state_.options.backbone, kBackboneChoices);
        if (state_.options.backbone == Backbone::ScreenSpace) {
            state_.options = inScreenSpace(state_.options);
        }
        return;
    case Command::NextEstimator:
        state_.options.estimator = following(state_.options.estimator, kEstimatorChoices);
        return;
    case Command::Gizmos:
        return toggle(state_.gizmos);
    case Command::PlaceCubeMap:
    case Command::RemoveCubeMap:
    case Command::ClearCubeMaps:
        return changeCubeMaps(command);
    case Command::Screenshot:
        screenshotWanted_ = true;
        return;
    case Command::ExportCase:
        return exportCase();
    case Command::Quit:
        return window_->close();
    }
}

void Viewer::execute(const PanelActions& actions) {
    for (const Command command : actions.commands) {
        execute(command);
    }
    if (actions.open) {
        openScene(*actions.open);
    }
    if (actions.camera) {
        for (const NamedCamera& camera : scene_->cameras()) {
            if (camera.name == *actions.camera) {
                goToCamera(camera);
            }
        }
    }
}

void Viewer::goToCamera(const NamedCamera& camera) {
    state_.camera.place(camera);
    messages_.tell("camera: " + camera.name);
}

void Viewer::openScene(const std::string& nameOrPath) {
    if (isEnvironmentFile(nameOrPath)) {
        state_.environment = nameOrPath;
        state_.compared = ComparedMethod::Environment;
        return;
    }
    if (loader_.busy()) {
        messages_.warn(nameOrPath + ": another scene is still being opened");
        return;
    }
    loader_.open(nameOrPath);
    guiFrames_ = std::max(guiFrames_, 2);
}

void Viewer::changeCubeMaps(Command command) {
    AmbientOcclusion& ao = scene_->ao();
    AoStatus status;
    if (command == Command::PlaceCubeMap) {
        const Result<CubeMapId> placed = ao.addCubeMap(state_.camera.camera().eye);
        status = placed.status();
        if (placed) {
            state_.chosen = *placed;
        }
    } else if (command == Command::ClearCubeMaps) {
        status = ao.clear();
        state_.chosen.reset();
    } else if (state_.chosen) {
        status = ao.removeCubeMap(*state_.chosen);
        state_.chosen.reset();
    } else {
        messages_.tell("choose a cube map first: click its mark or its line in the panel");
        return;
    }
    if (!status) {
        messages_.warn(status.message());
    }
    scene_->touch();
    picture_.forget();
}

app::MaybeFailure Viewer::saveScreenshot(const fs::path& file) const {
    app::OutputFiles files;
    if (auto failure = files.announce("--screenshot", file, {".png"})) {
        return failure;
    }
    files.put(file, SplitPicture::readWindow(window_->session().gl(), window_->pixels()));
    return files.commit();
}

app::MaybeFailure Viewer::saveWhatIsDue() {
    if (std::exchange(screenshotWanted_, false)) {
        const fs::path file = nextNumberedFile(settings_.folder, ".png");
        if (const auto failure = saveScreenshot(file)) {
            messages_.warn(failure->sentence);
        } else {
            messages_.tell("saved " + file.string());
            std::cout << "wrote " << file.string() << std::endl;
        }
        guiFrames_ = std::max(guiFrames_, 2);
    }
    if (ending() && !settings_.screenshot.empty()) {
        return saveScreenshot(settings_.screenshot);
    }
    return std::nullopt;
}

void Viewer::exportCase() {
    const fs::path file = nextNumberedFile(settings_.folder, ".json");
    const Case description = caseOf(scene_->view(), state_.camera.camera(), picturePixels(),
                                    state_.options, settings_.folder);
    if (const std::string problem = bench::writeText(file, writeCase(description));
        !problem.empty()) {
        messages_.warn(problem);
        return;
    }
    const std::string command =
        renderCommand(file.string(), state_.options, scene_->ao().cubeMaps());
    messages_.tell("saved " + file.string() + "; the same picture without a window:\n" + command);
    std::cout << "wrote " << file.string() << '\n' << command << std::endl;
}

app::MaybeFailure Viewer::writeState() {
    if (settings_.stateFile.empty()) {
        return std::nullopt;
    }
    const ReportFacts report{frames_, picturePixels(), settled(), messages_.latest(), gizmos_};
    const std::string text = stateReport(state_, facts(), panel_, report);
    if (const std::string problem = bench::writeText(settings_.stateFile, text); !problem.empty()) {
        return app::Failure{app::ExitCode::Failed, problem};
    }
    return std::nullopt;
}

} // namespace aolib::viewer
