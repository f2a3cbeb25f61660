#include "bench/ThesisRun.h"

#include <algorithm>
#include <utility>

#include <aolib/AmbientOcclusion.h>

#include "bench/CubeMapPositions.h"
#include "bench/HostedFrames.h"
#include "bench/OpenedScene.h"
#include "bench/TimeLeft.h"
#include "bench/WarmUp.h"
#include "host/AoInstance.h"
#include "host/ModelScene.h"

namespace aolib::bench {

namespace {

/// Times of one setting.
struct Times {
    std::vector<double> buildMs;
    std::vector<double> frameMs;
};

/// The library and a host in one scene. Context.
class SceneRun {
public:
    SceneRun(const OpenedScene& scene, const PictureSize& size, AmbientOcclusion ao,
             HostedFrames frames)
        : scene_(scene), size_(size), ao_(std::move(ao)), frames_(std::move(frames)) {
        frames_.setCamera(scene.cameras.front());
    }

    ThesisRow measure(const ThesisSetting& setting, const TimingSettings& timing) {
        ThesisRow row;
        row.scene = scene_.entry.name;
        row.triangles = scene_.model.triangleCount();
        row.setting = setting;
        Times times;
        if (const AoStatus status = measure(setting, timing, times); !status) {
            row.failure = status.message();
            return row;
        }
        row.buildMs = spreadOf(std::move(times.buildMs));
        row.frameMs = spreadOf(std::move(times.frameMs));
        const std::vector<CubeMapInfo> cubeMaps = ao_.cubeMaps();
        for (const CubeMapInfo& info : cubeMaps) {
            row.layers = std::max(row.layers, info.layers);
            row.bytesCapture = std::max(row.bytesCapture, info.captureBytes);
            row.bytesKept += info.bytes;
        }
        row.bytesKept /= std::max<std::size_t>(cubeMaps.size(), 1);
        return row;
    }

private:
    AoStatus measure(const ThesisSetting& setting, const TimingSettings& timing, Times& times) {
        const NamedCamera& camera = scene_.cameras.front();
        Options options = setting.options();
        options.radius = static_cast<float>(kWideRadius * scene_.diagonal);
        if (AoStatus status = warmUp(ao_, frames_, options, camera.eye); !status) {
            return status;
        }
        const std::vector<glm::vec3> positions =
            cubeMapPositions(scene_, camera, size_, setting.cubeMaps);
        for (int turn = 0; turn < timing.repeat; ++turn) {
            if (AoStatus status = build(positions, timing, times); !status) {
                return status;
            }
            for (int i = 0; i < timing.frames; ++i) {
                const Result<FrameTimes> frame = frames_.draw(ao_);
                if (!frame) {
                    return frame.status();
                }
                times.frameMs.push_back(frame->aoMs);
            }
        }
        return {};
    }

    /// Places cube maps and draws until nothing is left to compute.
    AoStatus build(const std::vector<glm::vec3>& positions, const TimingSettings& timing,
                   Times& times) {
        ao_.clear();
        frames_.finish();
        const Clock::time_point begin = Clock::now();
        for (const glm::vec3& position : positions) {
            if (const Result<CubeMapId> id = ao_.addCubeMap(position); !id) {
                return id.status();
            }
        }
        frames_.finish();
        double ms = millisecondsSince(begin);
        // The first frame is no part of a build that was done before it.
        for (bool first = true;; first = false) {
            const Result<FrameTimes> frame = frames_.draw(ao_);
            if (!frame) {
                return frame.status();
            }
            const Statistics statistics = ao_.statistics();
            const bool done = statistics.converged && statistics.cubeMapsBuilt == 0;
            ms += first && done ? 0.0 : frame->aoMs;
            if (done || millisecondsSince(begin) > timing.buildSeconds * kMsPerSecond) {
                break;
            }
        }
        times.buildMs.push_back(ms / static_cast<double>(positions.size()));
        return {};
    }

    const OpenedScene& scene_;
    const PictureSize size_;
    AmbientOcclusion ao_;
    HostedFrames frames_;
};

Result<SceneRun> beginScene(const gl::Functions& gl, const ProcAddressLoader& loader,
                            const OpenedScene& scene, const PictureSize& size) {
    Result<AmbientOcclusion> ao = host::createInstance(loader);
    if (!ao) {
        return ao.status();
    }
    if (const auto meshes = host::describeScene(*ao, scene.model, host::SceneNormals::Geometric);
        !meshes) {
        return meshes.status();
    }
    Result<HostedFrames> frames = HostedFrames::create(gl, scene.model, size);
    if (!frames) {
        return frames.status();
    }
    return SceneRun(scene, size, std::move(*ao), std::move(*frames));
}

std::string describe(const ThesisSetting& setting) {
    return std::string(estimatorName(setting.estimator)) + ", " +
           std::string(figureName(setting.figure)) + " " + std::to_string(setting.value());
}

} // namespace

Result<std::vector<ThesisRow>, LoadError> runThesis(const gl::Functions& gl,
                                                    const ProcAddressLoader& loader,
                                                    const ThesisRunSettings& settings,
                                                    const ThesisReports& reports) {
    TimeLeft left(settings.scenes.size(), settings.settings.size());
    std::vector<ThesisRow> rows;
    for (const BenchScene& entry : settings.scenes) {
        reports.stage(entry.name + ": opening");
        const Result<OpenedScene, LoadError> scene = openBenchScene(entry);
        if (!scene) {
            reports.warn("left out: " + scene.error().sentence);
            left.skipCase();
            continue;
        }
        Result<SceneRun> run = beginScene(gl, loader, *scene, settings.size);
        if (!run) {
            reports.warn("left out: " + entry.name + ": " + run.status().message());
            left.skipCase();
            continue;
        }
        for (std::size_t i = 0; i < settings.settings.size(); ++i) {
            const std::string remaining = left.text();
            reports.stage(entry.name + ": " + describe(settings.settings[i]) +
                          (remaining.empty() ? "" : ", " + remaining));
            reports.progress(left.fraction());
            const Clock::time_point begin = Clock::now();
            rows.push_back(run->measure(settings.settings[i], settings.timing));
            left.done(i, millisecondsSince(begin) / kMsPerSecond);
            if (!rows.back().failure.empty()) {
                reports.warn(entry.name + ", " + describe(settings.settings[i]) + ": " +
                             rows.back().failure);
            }
        }
        if (std::string reason = reports.sceneDone(rows); !reason.empty()) {
            return LoadError{reason};
        }
    }
    if (rows.empty()) {
        return LoadError{"none of the scenes asked for could be measured"};
    }
    return rows;
}

} // namespace aolib::bench
