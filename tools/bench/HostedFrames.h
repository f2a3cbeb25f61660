#pragma once

#include <chrono>
#include <vector>

#include <aolib/AmbientOcclusion.h>
#include <glm/mat4x4.hpp>

#include "bench/PassTimer.h"
#include "bench/Receivers.h"
#include "content/Model.h"
#include "content/NamedCamera.h"
#include "gl/Functions.h"
#include "host/HostFramebuffer.h"
#include "host/HostRenderer.h"

namespace aolib::bench {

using Clock = std::chrono::steady_clock;

inline constexpr double kMsPerSecond = 1000.0;

double millisecondsSince(Clock::time_point begin);

/// What a frame took, wall clock with the GPU's work done, milliseconds.
struct FrameTimes {
    double hostMs = 0.0; ///< the host's own drawing
    double aoMs = 0.0;   ///< aoDrawEnd()
};

/// A host that draws a model, and times itself and the library. Context.
class HostedFrames {
public:
    /// @param gl  must outlive it. Errors: as HostRenderer and HostFramebuffer.
    static Result<HostedFrames> create(const gl::Functions& gl, const Model& model,
                                       const PictureSize& size);

    void setCamera(const NamedCamera& camera);
    /// Draws one frame from this far to the right of the camera, world units, the next from the
    /// camera and so forth: never twice the same view in turn. 0: at rest.
    void setSway(float distance) { sway_ = distance; }
    /// Draws a frame with ambient occlusion. Errors: those of the library.
    Result<FrameTimes> draw(AmbientOcclusion& ao) { return draw(ao, nullptr); }
    /// The same, with `timer` started just before aoDrawEnd().
    Result<FrameTimes> drawTimed(AmbientOcclusion& ao, PassTimer& timer) {
        return draw(ao, &timer);
    }
    /// What the host alone draws: depths of all pixels, 0 to 1, row 0 at the bottom.
    std::vector<float> drawDepths();
    void finish() const { gl_->Finish(); }

private:
    Result<FrameTimes> draw(AmbientOcclusion& ao, PassTimer* timer);

    HostedFrames(const gl::Functions& gl, host::HostRenderer renderer,
                 host::HostFramebuffer target);

    const gl::Functions* gl_;
    host::HostRenderer renderer_;
    host::HostFramebuffer target_;
    glm::mat4 view_{1.0F};
    glm::mat4 projection_{1.0F};
    glm::vec3 eye_{0.0F};
    float sway_ = 0.0F;
    bool swayed_ = false; ///< the latest frame's camera stood to the right
};

} // namespace aolib::bench
