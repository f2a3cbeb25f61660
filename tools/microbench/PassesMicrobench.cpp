// The library's passes on the GPU, one by one, in the town at 960 x 540 and a cube map of 256^2
// faces: what is reported is the pass alone, with the GPU's work done.
#include <memory>
#include <string>

#include <aolib/AmbientOcclusion.h>
#include <benchmark/benchmark.h>

#include "bench/CubeMapPositions.h"
#include "bench/HostedFrames.h"
#include "bench/OpenedScene.h"
#include "bench/PassTimer.h"
#include "host/ModelScene.h"
#include "platform/GlContext.h"

namespace aolib {
namespace {

constexpr bench::PictureSize kSize{960, 540};
constexpr double kMsPerSecond = 1000.0;

/// A context, the town and a host that draws it, made when first needed.
class Stage {
public:
    /// The one of this process.
    static Stage& instance() {
        static Stage stage;
        return stage;
    }

    /// Empty when all went well.
    const std::string& failure() const { return failure_; }
    AmbientOcclusion& ao() { return *ao_; }
    bench::HostedFrames& frames() { return *frames_; }
    bench::PassTimer& timer() { return timer_; }

    /// Options in force, cube maps placed, and one frame drawn.
    AoStatus prepare(const Options& options, int cubeMaps) {
        ao_->clear();
        if (AoStatus status = ao_->setOptions(options); !status) {
            return status;
        }
        for (const glm::vec3& place :
             bench::cubeMapPositions(*scene_, scene_->cameras.front(), kSize, cubeMaps)) {
            if (const auto id = ao_->addCubeMap(place); !id) {
                return id.status();
            }
        }
        return frames_->draw(*ao_).status();
    }
    glm::vec3 eye() const { return scene_->cameras.front().eye; }

private:
    Stage() {
        auto context = createOffscreenContext({});
        if (!context) {
            failure_ = context.status().message();
            return;
        }
        context_ = std::move(*context);
        if (AoStatus status = fill(); !status) {
            failure_ = status.message();
        }
    }

    AoStatus fill() {
        auto opened = bench::openBenchScene({"town", bench::SceneKind::Generated, false});
        auto gl = gl::Functions::load(context_->loader());
        if (!gl) {
            return gl.status();
        }
        scene_ = std::make_unique<bench::OpenedScene>(std::move(*opened));
        gl_ = std::make_unique<gl::Functions>(*gl);
        auto ao = AmbientOcclusion::create(timer_.wrap(context_->loader()));
        if (!ao) {
            return ao.status();
        }
        auto frames = bench::HostedFrames::create(*gl_, scene_->model, kSize);
        if (!frames) {
            return frames.status();
        }
        ao_ = std::make_unique<AmbientOcclusion>(std::move(*ao));
        frames_ = std::make_unique<bench::HostedFrames>(std::move(*frames));
        frames_->setCamera(scene_->cameras.front());
        return host::describeScene(*ao_, scene_->model, host::SceneNormals::Geometric).status();
    }

    std::string failure_;
    std::unique_ptr<GlContext> context_;
    std::unique_ptr<bench::OpenedScene> scene_;
    std::unique_ptr<gl::Functions> gl_;
    bench::PassTimer timer_;
    std::unique_ptr<AmbientOcclusion> ao_;
    std::unique_ptr<bench::HostedFrames> frames_;
};

Options smallOptions() {
    Options options;
    options.frameBudget = 0.0F;
    options.cubeMaps.place = false;
    options.cubeMaps.faceSize = 256;
    options.horizonSplit = {.directions = 4, .steps = 4};
    options.layeredIntervals.slices = 1;
    options.layeredIntervals.steps = 1;
    return options;
}

double secondsOf(const std::vector<bench::PassTime>& passes, const std::string& name) {
    for (const bench::PassTime& time : passes) {
        if (time.pass == name) {
            return time.ms / kMsPerSecond;
        }
    }
    return 0.0;
}

/// Frames, of which one pass counts.
void timeFramePass(benchmark::State& state, const Options& options, int cubeMaps,
                   const std::string& pass) {
    Stage& stage = Stage::instance();
    if (!stage.failure().empty()) {
        state.SkipWithError(stage.failure().c_str());
        return;
    }
    if (const AoStatus status = stage.prepare(options, cubeMaps); !status) {
        state.SkipWithError(status.message().c_str());
        return;
    }
    for (auto turn : state) {
        if (const auto frame = stage.frames().drawTimed(stage.ao(), stage.timer()); !frame) {
            state.SkipWithError(frame.status().message().c_str());
            return;
        }
        state.SetIterationTime(secondsOf(stage.timer().stop(), pass));
    }
}

void GeometryBufferPass(benchmark::State& state) {
    timeFramePass(state, smallOptions(), 1, "geometry buffer");
}
BENCHMARK(GeometryBufferPass)->UseManualTime()->Unit(benchmark::kMillisecond);

/// @param range  cube maps projected
void ProjectionPass(benchmark::State& state) {
    timeFramePass(state, smallOptions(), static_cast<int>(state.range(0)), "project cube maps");
}
BENCHMARK(ProjectionPass)->Arg(1)->Arg(10)->UseManualTime()->Unit(benchmark::kMillisecond);

/// @param range  pixels along the filter's edge; 0 for none
void BlurPass(benchmark::State& state) {
    Options options = smallOptions();
    options.blur.enabled = state.range(0) > 0;
    options.blur.size = options.blur.enabled ? static_cast<int>(state.range(0)) : 1;
    timeFramePass(state, options, 1, "blur");
}
BENCHMARK(BlurPass)->Arg(0)->Arg(3)->Arg(7)->UseManualTime()->Unit(benchmark::kMillisecond);

void CompositePass(benchmark::State& state) {
    timeFramePass(state, smallOptions(), 1, "composite");
}
BENCHMARK(CompositePass)->UseManualTime()->Unit(benchmark::kMillisecond);

/// @param range  layers captured at most
void PeelLayers(benchmark::State& state) {
    Stage& stage = Stage::instance();
    if (!stage.failure().empty()) {
        state.SkipWithError(stage.failure().c_str());
        return;
    }
    Options options = smallOptions();
    options.estimator = Estimator::LayeredIntervals;
    options.layeredIntervals.layers = static_cast<int>(state.range(0));
    if (const AoStatus status = stage.prepare(options, 1); !status) {
        state.SkipWithError(status.message().c_str());
        return;
    }
    for (auto turn : state) {
        stage.ao().clear();
        stage.timer().start();
        if (const auto id = stage.ao().addCubeMap(stage.eye()); !id) {
            state.SkipWithError(id.status().message().c_str());
            return;
        }
        state.SetIterationTime(secondsOf(stage.timer().stop(), "peel layers"));
    }
}
BENCHMARK(PeelLayers)->Arg(1)->Arg(2)->Arg(8)->UseManualTime()->Unit(benchmark::kMillisecond);

} // namespace
} // namespace aolib
