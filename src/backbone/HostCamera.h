#pragma once

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/Status.h>

#include "gl/GLSLShader.h"

namespace aolib {

/// How the host's GL turns clip space into windows: part of what depth values mean.
struct ClipConvention {
    bool zeroToOne = false;                     ///< clip depth in [0,1] instead of [-1,1]
    bool upperLeft = false;                     ///< window rows count from the top
    std::array<double, 2> depthRange{0.0, 1.0}; ///< glDepthRange
    double depthQuantum = 1.0 / 16777215.0;     ///< step of the depth buffer's values
};

/// The host's camera: perspective or orthographic, centred or not, any depth convention.
class HostCamera {
public:
    /// @param view        world to eye, a rotation (or mirror) and a translation
    /// @param projection  eye to clip
    /// Errors: InvalidCamera.
    static Result<HostCamera> create(const glm::mat4& view, const glm::mat4& projection);

    /// World position of the eye.
    const glm::dvec3& eye() const { return eye_; }
    /// Eye to world, the rotation only.
    const glm::dmat3& eyeToWorld() const { return eyeToWorld_; }
    const glm::dmat4& projection() const { return projection_; }

    /// Whether nearer points have the larger depth values.
    bool reversedDepth() const;
    /// Sets the uniforms of shaders/frame/host_view.glsl.
    void setUniforms(gl::GLSLShader& shader, const glm::ivec2& size,
                     const ClipConvention& clip) const;

private:
    glm::dmat4 projection_{1.0};
    glm::dmat3 eyeToWorld_{1.0};
    glm::dvec3 eye_{0.0};
};

} // namespace aolib
