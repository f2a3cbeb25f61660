#include "app/RenderJob.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include <aolib/AmbientOcclusion.h>

#include "host/AoInstance.h"
#include "host/HostFramebuffer.h"
#include "host/HostRenderer.h"

namespace aolib::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kTimedFrames = 7;
constexpr int kFewestTimedFrames = 3;
constexpr double kTimingBudgetMs = 3000.0;
/// Frames granted beyond those asked for, while cube maps still appear or coverage is not known.
constexpr int kExtraFrames = 8;
/// Between frames while cube maps are computed: the tracer's workers have better use for the time.
constexpr std::chrono::milliseconds kPause{20};

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

double median(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct FrameTime {
    double hostMs = 0.0;
    double aoMs = 0.0;
    bool built = false;     ///< a cube map was built in it
    bool computing = false; ///< and something is left to compute after it
};

/// Draws the frames of one job.
class JobRunner {
public:
    JobRunner(const GlSession& session, const RenderJob& job, AmbientOcclusion ao,
              host::HostRenderer renderer, host::HostFramebuffer target, Progress& progress)
        : gl_(session.gl()), job_(job), progress_(progress), ao_(std::move(ao)),
          renderer_(std::move(renderer)), target_(std::move(target)), view_(viewMatrix(job.camera)),
          projection_(projectionMatrix(job.camera, static_cast<float>(job.width) /
                                                       static_cast<float>(job.height))) {}

    AoStatus run(RenderResult& result);

private:
    AoStatus placeByHand();
    AoStatus drawFrame();
    AoStatus drawUntilSettled();
    AoStatus drawTimed();
    AoStatus readPictures(RenderResult& result);
    AoStatus readDebugViews(RenderResult& result);
    void countUp(RenderResult& result) const;

    const gl::Functions& gl_;
    const RenderJob& job_;
    Progress& progress_;
    AmbientOcclusion ao_;
    host::HostRenderer renderer_;
    host::HostFramebuffer target_;
    glm::mat4 view_;
    glm::mat4 projection_;
    std::vector<FrameTime> frames_;
    std::size_t firstTimed_ = 0; ///< all is computed from there on
    double handBuildMs_ = 0.0;
    double convergedMs_ = 0.0; ///< wall clock until all was computed, where it takes many frames
};

AoStatus JobRunner::run(RenderResult& result) {
    target_.bind();
    renderer_.draw(view_, projection_);
    Result<ByteImage> colour = target_.readColour();
    if (!colour) {
        return colour.status();
    }
    result.colour = std::move(*colour);
    for (const auto step :
         {&JobRunner::placeByHand, &JobRunner::drawUntilSettled, &JobRunner::drawTimed}) {
        if (AoStatus status = (this->*step)(); !status) {
            return status;
        }
    }
    countUp(result);
    if (AoStatus status = readPictures(result); !status) {
        return status;
    }
    return readDebugViews(result);
}

AoStatus JobRunner::placeByHand() {
    gl_.Finish();
    const Clock::time_point begin = Clock::now();
    for (const glm::vec3& position : job_.cubeMaps) {
        if (const Result<CubeMapId> id = ao_.addCubeMap(position); !id) {
            return id.status();
        }
    }
    gl_.Finish();
    handBuildMs_ = job_.cubeMaps.empty() ? 0.0 : millisecondsSince(begin);
    return ao_.aoSetCamera(view_, projection_);
}

AoStatus JobRunner::drawFrame() {
    FrameTime time;
    target_.bind();
    gl_.Finish();
    const Clock::time_point begin = Clock::now();
    if (AoStatus status = ao_.aoDrawBegin(); !status) {
        return status;
    }
    renderer_.draw(view_, projection_);
    gl_.Finish();
    time.hostMs = millisecondsSince(begin);
    const Clock::time_point drawn = Clock::now();
    const glm::vec3& eye = job_.camera.eye;
    if (AoStatus status = ao_.aoDrawEnd(eye.x, eye.y, eye.z); !status) {
        return status;
    }
    gl_.Finish();
    time.aoMs = millisecondsSince(drawn);
    time.built = ao_.statistics().cubeMapsBuilt > 0;
    time.computing = job_.options.backbone == Backbone::Cubemapped &&
                     job_.options.frameBudget > 0.0F && !ao_.statistics().converged;
    frames_.push_back(time);
    return {};
}

AoStatus JobRunner::drawUntilSettled() {
    const auto settled = [this] {
        return job_.options.backbone != Backbone::Cubemapped ||
               (!frames_.back().built && ao_.statistics().coverage >= 0.0F);
    };
    const Clock::time_point begin = Clock::now();
    int extra = 0;
    for (int frame = 0;; ++frame) {
        if (AoStatus status = drawFrame(); !status) {
            return status;
        }
        const bool converged = ao_.statistics().converged;
        const bool progressive = job_.options.frameBudget > 0.0F;
        if (!converged && progressive) {
            progress_.update(static_cast<double>(ao_.statistics().computed));
            convergedMs_ = millisecondsSince(begin);
            std::this_thread::sleep_for(kPause);
            continue;
        }
        extra += frame >= job_.frames ? 1 : 0;
        if (frame + 1 >= job_.frames && (settled() || extra >= kExtraFrames)) {
            return {};
        }
    }
}

AoStatus JobRunner::drawTimed() {
    firstTimed_ = frames_.size();
    const Clock::time_point begin = Clock::now();
    for (int frame = 0; frame < kTimedFrames; ++frame) {
        if (frame >= kFewestTimedFrames && millisecondsSince(begin) > kTimingBudgetMs) {
            break;
        }
        if (AoStatus status = drawFrame(); !status) {
            return status;
        }
    }
    return {};
}

void JobRunner::countUp(RenderResult& result) const {
    std::vector<double> ao;
    std::vector<double> host;
    std::vector<double> computing;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
        if (frames_[i].computing) {
            computing.push_back(frames_[i].aoMs);
        } else if (i >= firstTimed_ && !frames_[i].built) {
            ao.push_back(frames_[i].aoMs);
            host.push_back(frames_[i].hostMs);
        }
    }
    result.computingMs = computing.empty() ? -1.0 : median(std::move(computing));
    result.aoMs = median(std::move(ao));
    result.hostMs = median(std::move(host));
    result.buildMs = handBuildMs_ + convergedMs_;
    for (const FrameTime& frame : frames_) {
        result.buildMs +=
            frame.built && convergedMs_ <= 0.0 ? std::max(frame.aoMs - result.aoMs, 0.0) : 0.0;
    }
    const Statistics statistics = ao_.statistics();
    result.cubeMaps = ao_.cubeMaps().size();
    result.coverage = static_cast<double>(statistics.coverage);
    result.bytesKept = statistics.bytesKept;
    for (const CubeMapInfo& cubeMap : ao_.cubeMaps()) {
        result.bytesCapture = std::max(result.bytesCapture, cubeMap.captureBytes);
    }
}

AoStatus JobRunner::readPictures(RenderResult& result) {
    Result<ByteImage> composite = target_.readColour();
    if (!composite) {
        return composite.status();
    }
    result.composite = std::move(*composite);
    Result<VisibilityImage> visibility = ao_.readVisibility();
    if (!visibility) {
        return visibility.status();
    }
    result.visibility = FloatImage(visibility->width, visibility->height, 1);
    result.visibility.pixels = std::move(visibility->visibility);
    return {};
}

AoStatus JobRunner::readDebugViews(RenderResult& result) {
    for (const DebugView view : job_.debugViews) {
        Options options = job_.options;
        options.debugView = view;
        if (AoStatus status = ao_.setOptions(options); !status) {
            return status;
        }
        if (AoStatus status = drawFrame(); !status) {
            return status;
        }
        Result<ByteImage> picture = target_.readColour();
        if (!picture) {
            return picture.status();
        }
        result.debugPictures.push_back(std::move(*picture));
    }
    return {};
}

} // namespace

Failure failureOf(const AoStatus& status) {
    switch (status.code()) {
    case StatusCode::NoContext:
    case StatusCode::MissingCapability:
    case StatusCode::ShaderError:
    case StatusCode::OutOfMemory:
    case StatusCode::InvalidFramebuffer:
        return graphicsFailure(status.message());
    default:
        return badInput(status.message());
    }
}

Result<RenderResult, Failure> render(const GlSession& session, const Model& model,
                                     const RenderJob& job, Progress& progress) {
    progress.begin(model.name + ": rendering");
    Result<AmbientOcclusion> ao = host::createInstance(session.loader(), job.options);
    if (!ao) {
        return failureOf(ao.status());
    }
    if (const auto meshes = host::describeScene(*ao, model, job.normals); !meshes) {
        return failureOf(meshes.status());
    }
    Result<host::HostRenderer> renderer = host::HostRenderer::create(session.gl(), model);
    if (!renderer) {
        return failureOf(renderer.status());
    }
    Result<host::HostFramebuffer> target =
        host::HostFramebuffer::create(session.gl(), {job.width, job.height, job.samples});
    if (!target) {
        return failureOf(target.status());
    }
    RenderResult result;
    JobRunner runner(session, job, std::move(*ao), std::move(*renderer), std::move(*target),
                     progress);
    if (const AoStatus status = runner.run(result); !status) {
        return failureOf(status);
    }
    progress.pause();
    return result;
}

} // namespace aolib::app
