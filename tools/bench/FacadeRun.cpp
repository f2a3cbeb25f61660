#include "bench/FacadeRun.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <aolib/AmbientOcclusion.h>

#include "bench/CubeMapPositions.h"
#include "bench/HostedFrames.h"
#include "bench/WarmUp.h"
#include "host/AoInstance.h"
#include "host/ModelScene.h"

namespace aolib::bench {

namespace {

/// Share of the scene's diagonal by which a moving camera goes to and fro.
constexpr double kSway = 1.0e-4;

/// A build is looked at again when it has taken so many times as long.
constexpr double kLookAgain = 1.25;

/// Times of all builds of a measurement.
struct Gathered {
    std::vector<double> frameMs;
    std::vector<double> hostMs;
    std::vector<double> buildMs;
    std::vector<double> convergedMs;
};

/// A build so far.
struct Build {
    Clock::time_point began;
    double hostMs = 0.0; ///< spent on the host's drawing since then
    double nextLook = 0.0;
    int frames = 0;
    bool shown = false; ///< a frame showed the method's result

    /// Wall clock since it began, the host's drawing left out.
    double spent() const { return millisecondsSince(began) - hostMs; }
};

} // namespace

struct FacadeRun::Impl {
    Impl(const OpenedScene& opened, const PictureSize& pictureSize,
         std::unique_ptr<PassTimer> passTimer, AmbientOcclusion library, HostedFrames host)
        : scene(opened), size(pictureSize), timer(std::move(passTimer)), ao(std::move(library)),
          frames(std::move(host)) {}

    AoStatus giveOrTakeTracer(bool wanted);
    AoStatus buildOnce(const FacadeMethod& method, const std::vector<glm::vec3>& positions,
                       const Truth& truth, const TimingSettings& timing, Measurement& m,
                       Gathered& all);
    AoStatus converge(const Options& options, const Truth& truth, const TimingSettings& timing,
                      Build& build, Measurement& m);
    AoStatus look(const Truth& truth, double spent, Build& build, Measurement& m);
    AoStatus timeFrames(const TimingSettings& timing, Gathered& all);
    AoStatus timePasses(const std::vector<glm::vec3>& positions, const TimingSettings& timing,
                        Measurement& m);
    void countMemory(Measurement& m) const;

    const OpenedScene& scene;
    const PictureSize size;
    std::unique_ptr<PassTimer> timer; ///< outlives `ao`, which has its functions
    AmbientOcclusion ao;
    HostedFrames frames;
    bool tracer = true; ///< `ao` has one
    float sway = 0.0F;  ///< world units, while frames are timed
};

FacadeRun::FacadeRun(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FacadeRun::FacadeRun(FacadeRun&&) noexcept = default;
FacadeRun::~FacadeRun() = default;

Result<FacadeRun, LoadError> FacadeRun::create(const gl::Functions& gl,
                                               const ProcAddressLoader& loader,
                                               const OpenedScene& scene, const PictureSize& size) {
    const auto failed = [&](const AoStatus& status) {
        return LoadError{scene.entry.name + ": " + status.message()};
    };
    auto timer = std::make_unique<PassTimer>();
    Result<AmbientOcclusion> ao = host::createInstance(timer->wrap(loader));
    if (!ao) {
        return failed(ao.status());
    }
    if (const auto meshes = host::describeScene(*ao, scene.model, host::SceneNormals::Geometric);
        !meshes) {
        return failed(meshes.status());
    }
    Result<HostedFrames> frames = HostedFrames::create(gl, scene.model, size);
    if (!frames) {
        return failed(frames.status());
    }
    return FacadeRun(
        std::make_unique<Impl>(scene, size, std::move(timer), std::move(*ao), std::move(*frames)));
}

Measurement FacadeRun::measure(const FacadeMethod& method, const BenchCase& which,
                               const Truth& truth, const TimingSettings& timing) {
    const NamedCamera& camera = impl_->scene.cameras[which.camera];
    FacadeMethod sized = method;
    sized.options.radius = static_cast<float>(which.radiusShare * impl_->scene.diagonal);
    impl_->frames.setCamera(camera);
    impl_->sway = method.moving ? static_cast<float>(kSway * impl_->scene.diagonal) : 0.0F;
    const std::vector<glm::vec3> positions =
        cubeMapPositions(impl_->scene, camera, impl_->size, method.cubeMaps);
    Measurement m;
    Gathered all;
    AoStatus status = impl_->giveOrTakeTracer(method.tracer);
    if (!status) {
        m.failure = status.message();
        return m;
    }
    status = warmUp(impl_->ao, impl_->frames, sized.options, camera.eye);
    for (int turn = 0; status && turn < timing.repeat; ++turn) {
        status = impl_->buildOnce(sized, positions, truth, timing, m, all);
    }
    if (status) {
        impl_->countMemory(m);
        status = impl_->timePasses(positions, timing, m);
    }
    if (!status) {
        m.failure = status.message();
        return m;
    }
    m.frameMs = spreadOf(std::move(all.frameMs));
    m.hostMs = spreadOf(std::move(all.hostMs));
    m.buildMs = spreadOf(std::move(all.buildMs));
    m.convergedMs = spreadOf(std::move(all.convergedMs));
    return m;
}

std::vector<float> FacadeRun::drawDepths(const NamedCamera& camera) {
    impl_->frames.setCamera(camera);
    return impl_->frames.drawDepths();
}

AoStatus FacadeRun::Impl::buildOnce(const FacadeMethod& method,
                                    const std::vector<glm::vec3>& positions, const Truth& truth,
                                    const TimingSettings& timing, Measurement& m, Gathered& all) {
    ao.clear();
    frames.setSway(0.0F);
    frames.finish();
    m.path.clear();
    Build build{.began = Clock::now()};
    for (const glm::vec3& position : positions) {
        if (const Result<CubeMapId> id = ao.addCubeMap(position); !id) {
            return id.status();
        }
    }
    frames.finish();
    if (AoStatus status = converge(method.options, truth, timing, build, m); !status) {
        return status;
    }
    const double convergedMs = m.path.back().ms;
    Gathered now;
    if (AoStatus status = timeFrames(timing, now); !status) {
        return status;
    }
    const double usual = spreadOf(now.frameMs).median;
    all.convergedMs.push_back(convergedMs);
    all.buildMs.push_back(positions.empty() ? 0.0
                                            : std::max(convergedMs - build.frames * usual, 0.0));
    all.frameMs.insert(all.frameMs.end(), now.frameMs.begin(), now.frameMs.end());
    all.hostMs.insert(all.hostMs.end(), now.hostMs.begin(), now.hostMs.end());
    return {};
}

AoStatus FacadeRun::Impl::giveOrTakeTracer(bool wanted) {
    if (tracer == wanted) {
        return {};
    }
    tracer = wanted;
    if (wanted) {
        return host::giveTracer(ao);
    }
    ao.setTexelTracer({});
    return {};
}

AoStatus FacadeRun::Impl::converge(const Options& options, const Truth& truth,
                                   const TimingSettings& timing, Build& build, Measurement& m) {
    const double beforeFrames = build.spent(); // spent in addCubeMap()
    m.worstFrameMs = -1.0;
    for (;;) {
        const Result<FrameTimes> frame = frames.draw(ao);
        if (!frame) {
            return frame.status();
        }
        build.hostMs += frame->hostMs;
        const double spent = build.spent();
        ++build.frames;
        const Statistics statistics = ao.statistics();
        m.worstFrameMs = std::max(m.worstFrameMs, frame->aoMs);
        const bool shows =
            options.backbone == Backbone::ScreenSpace || statistics.cubeMapsProjected > 0;
        // A frame that built something may not show all of it yet: look at one more.
        const bool done = shows && statistics.converged && statistics.cubeMapsBuilt == 0;
        m.converged = done;
        const bool over = spent - beforeFrames > timing.buildSeconds * kMsPerSecond;
        if (done || over || (shows && (!build.shown || spent >= build.nextLook))) {
            if (AoStatus status = look(truth, spent, build, m); !status) {
                return status;
            }
        }
        if (done || over) {
            m.framesToConverge = build.frames;
            return {};
        }
    }
}

/// Reads the picture back and notes what it is worth.
AoStatus FacadeRun::Impl::look(const Truth& truth, double spent, Build& build, Measurement& m) {
    const Result<VisibilityImage> picture = ao.readVisibility();
    if (!picture) {
        return picture.status();
    }
    m.final = compareWithTruth(picture->visibility, truth);
    m.path.push_back({spent, m.final.rmse});
    if (!build.shown) {
        build.shown = true;
        m.first = m.final;
        m.firstMs = spent;
    }
    build.nextLook = kLookAgain * spent;
    return {};
}

AoStatus FacadeRun::Impl::timeFrames(const TimingSettings& timing, Gathered& all) {
    frames.setSway(sway);
    if (const Result<FrameTimes> warm = frames.draw(ao); !warm) {
        return warm.status();
    }
    for (int i = 0; i < timing.frames; ++i) {
        const Result<FrameTimes> frame = frames.draw(ao);
        if (!frame) {
            return frame.status();
        }
        all.frameMs.push_back(frame->aoMs);
        all.hostMs.push_back(frame->hostMs);
    }
    return {};
}

/// Frames and one more build with a timer that waits after every pass.
AoStatus FacadeRun::Impl::timePasses(const std::vector<glm::vec3>& positions,
                                     const TimingSettings& timing, Measurement& m) {
    if (!timing.passes) {
        return {};
    }
    std::vector<std::vector<PassTime>> lists;
    for (int i = 0; i < timing.frames; ++i) {
        const Result<FrameTimes> frame = frames.drawTimed(ao, *timer);
        if (!frame) {
            return frame.status();
        }
        lists.push_back(timer->stop());
    }
    m.framePasses = medianPasses(lists);
    if (positions.empty()) {
        return {};
    }
    ao.clear();
    frames.setSway(0.0F);
    timer->start();
    const Result<CubeMapId> id = ao.addCubeMap(positions.front());
    m.buildPasses = timer->stop();
    return id.status();
}

void FacadeRun::Impl::countMemory(Measurement& m) const {
    const Statistics statistics = ao.statistics();
    m.coverage = static_cast<double>(statistics.coverage);
    m.bytesKept = statistics.bytesKept;
    m.bytesFrame = statistics.bytesFrame;
    m.bytesCapture = 0;
    for (const CubeMapInfo& cubeMap : ao.cubeMaps()) {
        m.bytesCapture = std::max(m.bytesCapture, cubeMap.captureBytes);
    }
}

} // namespace aolib::bench
