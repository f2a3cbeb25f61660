#include "HostView.h"

#include <array>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "scene/Finite.h"

namespace aolib {

namespace {

// Compatibility-profile names, which the core header does not declare.
constexpr GLenum kModelViewMatrix = 0x0BA6;
constexpr GLenum kProjectionMatrix = 0x0BA7;
/// How far, relative to its distance from the origin, a camera read from GL may be from the
/// position that aoDrawEnd() is given.
constexpr double kSamePosition = 1e-3;

bool standsAt(const HostCamera& camera, const glm::vec3& position) {
    const glm::dvec3 given(position);
    const double most = kSamePosition * (1.0 + glm::length(given));
    return glm::distance(camera.eye(), given) <= most ||
           glm::distance(camera.viewOrigin(), given) <= most;
}

/// Whether greater depth values are nearer, from the host's GL state: the depth buffer is cleared
/// to less than 0.5, or the depth comparison is GL_GREATER or GL_GEQUAL.
bool greaterIsNearer(const gl::Functions& gl) {
    GLdouble cleared = 1.0;
    gl.GetDoublev(GL_DEPTH_CLEAR_VALUE, &cleared);
    GLint comparison = GL_LESS;
    gl.GetIntegerv(GL_DEPTH_FUNC, &comparison);
    return cleared < 0.5 || comparison == GL_GREATER || comparison == GL_GEQUAL;
}

} // namespace

HostView::Matrices HostView::readMatrices(const gl::Functions& gl) {
    Matrices read{};
    gl.GetFloatv(kModelViewMatrix, glm::value_ptr(read.view));
    gl.GetFloatv(kProjectionMatrix, glm::value_ptr(read.projection));
    return read;
}

AoStatus HostView::setCamera(const glm::mat4& view, const glm::mat4& projection) {
    const Result<HostCamera> camera = HostCamera::create(view, projection);
    if (camera) {
        camera_ = *camera;
    }
    return camera.status();
}

void HostView::begin(const gl::Functions& gl) {
    atBegin_.reset();
    if (!camera_ && gl.capabilities.compatibility) {
        atBegin_ = readMatrices(gl);
    }
}

Result<HostCamera> HostView::cameraAt(const gl::Functions& gl, const glm::vec3& position) const {
    if (camera_) {
        return *camera_;
    }
    if (!gl.capabilities.compatibility) {
        return AoStatus(
            StatusCode::NoCamera,
            "no camera is set, and a core profile has no matrices to read; call aoSetCamera first");
    }
    // Use the matrices of the call, begin or end, whose camera stands at the position.
    const Matrices now = readMatrices(gl);
    const Result<HostCamera> atEnd = HostCamera::create(now.view, now.projection);
    if (atEnd && standsAt(*atEnd, position)) {
        return atEnd;
    }
    if (atBegin_) {
        const Result<HostCamera> begun = HostCamera::create(atBegin_->view, atBegin_->projection);
        if (begun && standsAt(*begun, position)) {
            return begun;
        }
    }
    return AoStatus(StatusCode::InvalidCamera,
                    "GL's modelview matrix matches the position given to aoDrawEnd neither at "
                    "aoDrawBegin nor at aoDrawEnd; load only the camera's matrix at one of these "
                    "calls, or call aoSetCamera");
}

Result<Frame> HostView::frameFrom(const gl::Functions& gl, const gl::StateGuard& guard,
                                  const glm::vec3& position) const {
    if (!isFinite(position)) {
        return AoStatus(StatusCode::InvalidCamera, "the camera's position must be finite");
    }
    const Result<HostCamera> found = cameraAt(gl, position);
    if (!found) {
        return found.status();
    }
    const ClipConvention clip{.zeroToOne = guard.hostClipDepthMode() == GL_ZERO_TO_ONE,
                              .upperLeft = guard.hostClipOrigin() == GL_UPPER_LEFT,
                              .depthRange = guard.hostDepthRange()};
    if (clip.depthRange[0] == clip.depthRange[1]) {
        return AoStatus(StatusCode::InvalidFramebuffer,
                        "glDepthRange is empty, so depth values hold no distances; set near and "
                        "far to different "
                        "values");
    }
    const Result<HostCamera> camera =
        found->under(clip, found->orthographic() && greaterIsNearer(gl));
    if (!camera) {
        return camera.status();
    }
    return Frame{.camera = *camera, .position = position, .clip = clip};
}

AoStatus HostView::takeTarget(const gl::StateGuard& guard, Frame& frame) {
    const std::array<GLint, 4>& viewport = guard.hostViewport();
    if (viewport[2] < 1 || viewport[3] < 1) {
        return {StatusCode::InvalidFramebuffer, "the viewport is " + std::to_string(viewport[2]) +
                                                    " x " + std::to_string(viewport[3]) +
                                                    " pixels; width and height must be at least 1"};
    }
    frame.framebuffer = frame.depthFramebuffer = guard.hostDrawFramebuffer();
    frame.origin = {viewport[0], viewport[1]};
    frame.size = {viewport[2], viewport[3]};
    frame.srgb = guard.hostSrgb();
    frame.scissor = guard.hostScissor();
    return {};
}

} // namespace aolib
