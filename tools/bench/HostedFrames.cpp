#include "bench/HostedFrames.h"

#include <utility>

#include <glm/gtc/matrix_transform.hpp>

namespace aolib::bench {

namespace {

/// The view of an eye that stands `distance` to the right of a view's.
glm::mat4 rightOf(const glm::mat4& view, float distance) {
    return glm::translate(glm::mat4(1.0F), {-distance, 0.0F, 0.0F}) * view;
}

} // namespace

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

HostedFrames::HostedFrames(const gl::Functions& gl, host::HostRenderer renderer,
                           host::HostFramebuffer target)
    : gl_(&gl), renderer_(std::move(renderer)), target_(std::move(target)) {}

Result<HostedFrames> HostedFrames::create(const gl::Functions& gl, const Model& model,
                                          const PictureSize& size) {
    Result<host::HostRenderer> renderer = host::HostRenderer::create(gl, model);
    if (!renderer) {
        return renderer.status();
    }
    Result<host::HostFramebuffer> target =
        host::HostFramebuffer::create(gl, {size.width, size.height, 0});
    if (!target) {
        return target.status();
    }
    return HostedFrames(gl, std::move(*renderer), std::move(*target));
}

void HostedFrames::setCamera(const NamedCamera& camera) {
    const host::HostFramebuffer::Settings& size = target_.settings();
    view_ = viewMatrix(camera);
    projection_ =
        projectionMatrix(camera, static_cast<float>(size.width) / static_cast<float>(size.height));
    eye_ = camera.eye;
}

std::vector<float> HostedFrames::drawDepths() {
    target_.bind();
    renderer_.draw(view_, projection_);
    return target_.readDepth();
}

Result<FrameTimes> HostedFrames::draw(AmbientOcclusion& ao, PassTimer* timer) {
    swayed_ = !swayed_ && sway_ != 0.0F;
    const glm::mat4 view = swayed_ ? rightOf(view_, sway_) : view_;
    if (AoStatus status = ao.aoSetCamera(view, projection_); !status) {
        return status;
    }
    FrameTimes times;
    target_.bind();
    finish();
    const Clock::time_point begin = Clock::now();
    if (AoStatus status = ao.aoDrawBegin(); !status) {
        return status;
    }
    renderer_.draw(view, projection_);
    finish();
    times.hostMs = millisecondsSince(begin);
    if (timer != nullptr) {
        timer->start();
    }
    const Clock::time_point drawn = Clock::now();
    if (AoStatus status = ao.aoDrawEnd(eye_.x, eye_.y, eye_.z); !status) {
        return status;
    }
    finish();
    times.aoMs = millisecondsSince(drawn);
    return times;
}

} // namespace aolib::bench
