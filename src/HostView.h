#pragma once

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "backbone/frame/Frame.h"
#include "backbone/frame/HostCamera.h"
#include "gl/Functions.h"
#include "gl/StateGuard.h"

namespace aolib {

/// What the host looks through and draws to: its camera, as it was given or as GL has it, GL's
/// conventions, and the framebuffer.
class HostView {
public:
    /// The camera of all frames from now on. Errors: InvalidCamera; then the one before stays.
    AoStatus setCamera(const glm::mat4& view, const glm::mat4& projection);
    /// Where the camera stands that was given, world units.
    glm::vec3 eye() const { return camera_ ? glm::vec3(camera_->eye()) : glm::vec3(0.0F); }
    /// A frame begins. Without a camera, notes GL's matrices in a compatibility context.
    void begin(const gl::Functions& gl);

    /// A frame seen from `position`, world units, but for what it is drawn to. Conventions are
    /// those that the guard has saved. Errors: NoCamera, InvalidCamera, InvalidFramebuffer (an
    /// empty depth range).
    Result<Frame> frameFrom(const gl::Functions& gl, const gl::StateGuard& guard,
                            const glm::vec3& position) const;
    /// What the host draws to, by what the guard has saved. Errors: InvalidFramebuffer (no pixels).
    static AoStatus takeTarget(const gl::StateGuard& guard, Frame& frame);

private:
    struct Matrices {
        glm::mat4 view;
        glm::mat4 projection;
    };
    static Matrices readMatrices(const gl::Functions& gl);
    Result<HostCamera> cameraAt(const gl::Functions& gl, const glm::vec3& position) const;

    std::optional<HostCamera> camera_; ///< as it was given
    std::optional<Matrices> atBegin_;  ///< as GL had them when the frame began
};

} // namespace aolib
