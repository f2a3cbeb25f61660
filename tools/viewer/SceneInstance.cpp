#include "viewer/SceneInstance.h"

#include <chrono>
#include <utility>

#include <aolib/RayTracing.h>

#include "app/RenderJob.h"
#include "content/SceneSource.h"
#include "host/ModelScene.h"
#include "viewer/OptionTexts.h"

namespace aolib::viewer {

namespace {

using Clock = std::chrono::steady_clock;

/// Frames after a change until the survey of a view has been read and heeded; where one is lost, as
/// when a cube map appears, no more are waited for.
constexpr std::uint64_t kSurveyFrames = 12;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

} // namespace

Options inScreenSpace(Options options) {
    options.backbone = Backbone::ScreenSpace;
    if (options.estimator == Estimator::RayTraced) {
        options.estimator = Estimator::LayeredIntervals;
    }
    return options;
}

Result<std::unique_ptr<SceneInstance>, app::Failure>
SceneInstance::create(const app::GlSession& session, bench::PassTimer& timer, app::View view) {
    Result<AmbientOcclusion> ao = AmbientOcclusion::create(timer.wrap(session.loader()));
    if (!ao) {
        return app::failureOf(ao.status());
    }
    auto tracer = createTexelTracer(); // leaves a core to the window
    if (!tracer) {
        return app::failureOf(tracer.status());
    }
    ao->setTexelTracer(std::move(*tracer));
    if (const auto meshes = host::describeScene(*ao, view.model, view.normals); !meshes) {
        return app::failureOf(meshes.status());
    }
    Result<host::HostRenderer> renderer = host::HostRenderer::create(session.gl(), view.model);
    if (!renderer) {
        return app::failureOf(renderer.status());
    }
    return std::unique_ptr<SceneInstance>(
        new SceneInstance(session, timer, std::move(view), std::move(*ao), std::move(*renderer)));
}

SceneInstance::SceneInstance(const app::GlSession& session, bench::PassTimer& timer, app::View view,
                             AmbientOcclusion ao, host::HostRenderer renderer)
    : session_(&session), timer_(&timer), view_(std::move(view)), bounds_(view_.model.bounds()),
      triangles_(view_.model.triangleCount()), cameras_(camerasFor(view_.scene, view_.model)),
      ao_(std::move(ao)), renderer_(std::move(renderer)) {}

void SceneInstance::look(const NamedCamera& camera, float aspect) {
    const glm::mat4 view = aolib::viewMatrix(camera);
    const glm::mat4 projection = projectionMatrix(camera, aspect);
    changed_ = changed_ || view != viewMatrix_ || projection != projection_;
    eye_ = camera.eye;
    viewMatrix_ = view;
    projection_ = projection;
}

void SceneInstance::finish() const {
    session_->gl().Finish();
}

void SceneInstance::drawPlain(const host::HostFramebuffer& target) {
    target.bind();
    renderer_.draw(viewMatrix_, projection_);
}

AoStatus SceneInstance::drawShaded(const host::HostFramebuffer& target, const Options& options,
                                   std::vector<bench::PassTime>* measured) {
    if (optionTexts(options) != optionTexts(ao_.options())) {
        if (AoStatus status = ao_.setOptions(options); !status) {
            return status;
        }
        changed_ = true;
    }
    if (AoStatus status = drawWith(ao_, target, measured); !status) {
        return status;
    }
    if (changed_) {
        changed_ = false;
        changedFrame_ = ao_.statistics().frame;
    }
    return {};
}

AoStatus SceneInstance::drawScreenSpace(const host::HostFramebuffer& target,
                                        const Options& options) {
    const Options wanted = inScreenSpace(options);
    if (!screenSpace_) {
        if (AoStatus status = openScreenSpace(wanted); !status) {
            return status;
        }
    }
    if (AoStatus status = screenSpace_->setOptions(wanted); !status) {
        return status;
    }
    return drawWith(*screenSpace_, target, nullptr);
}

AoStatus SceneInstance::openScreenSpace(const Options& options) {
    Result<AmbientOcclusion> ao = AmbientOcclusion::create(session_->loader(), options);
    if (!ao) {
        return ao.status();
    }
    if (const auto meshes = host::describeScene(*ao, view_.model, view_.normals); !meshes) {
        return meshes.status();
    }
    screenSpace_.emplace(std::move(*ao));
    return {};
}

AoStatus SceneInstance::drawWith(AmbientOcclusion& ao, const host::HostFramebuffer& target,
                                 std::vector<bench::PassTime>* measured) {
    if (AoStatus status = ao.aoSetCamera(viewMatrix_, projection_); !status) {
        return status;
    }
    if (measured != nullptr) {
        finish();
    }
    const Clock::time_point begin = Clock::now();
    if (AoStatus status = ao.aoDrawBegin(); !status) {
        return status;
    }
    drawPlain(target);
    double hostMs = 0.0;
    if (measured != nullptr) {
        finish();
        hostMs = millisecondsSince(begin);
        timer_->start();
    }
    const AoStatus status = ao.aoDrawEnd(eye_.x, eye_.y, eye_.z);
    if (measured != nullptr) {
        *measured = timer_->stop();
        measured->insert(measured->begin(), {"host", hostMs});
    }
    return status;
}

bool SceneInstance::settled() const {
    const Statistics statistics = ao_.statistics();
    if (changed_ || !statistics.converged || statistics.cubeMapsBuilt > 0) {
        return false;
    }
    if (ao_.options().backbone != Backbone::Cubemapped) {
        return true;
    }
    return statistics.coverageFrame >= changedFrame_ ||
           statistics.frame >= changedFrame_ + kSurveyFrames;
}

} // namespace aolib::viewer
