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

    bool operator==(const ClipConvention&) const = default;
};

/// The host's camera: perspective or orthographic, centred or not, any handedness and depth
/// convention. Kept in one canonical form, whose product of projection and view is the host's but
/// for a positive factor: eye space has x right and y up in clip space and looks along -z, P00 and
/// P11 are positive, and clip w is -z or 1. What else the host's projection does (a mirror, a turn
/// of the picture, a shift of the eye, a scale) is part of the view.
class HostCamera {
public:
    /// @param view        world to eye, a rotation (or mirror) and a translation
    /// @param projection  eye to clip; of either handedness
    /// Errors: InvalidCamera.
    static Result<HostCamera> create(const glm::mat4& view, const glm::mat4& projection);

    /// Returns the camera with GL's clip conventions. The direction of an orthographic camera is
    /// the side of the eye on which the depth range lies. If the range contains the eye, the depth
    /// comparison decides.
    /// @param greaterIsNearer  the host keeps the greater of two values of the depth buffer.
    /// Errors: InvalidCamera, if nothing can be drawn with the projection.
    Result<HostCamera> under(const ClipConvention& clip, bool greaterIsNearer) const;

    /// World position of the eye, or for an orthographic camera of the view matrix's origin.
    const glm::dvec3& eye() const { return eye_; }
    /// World position of the view matrix's origin: the eye, unless the host's projection shifts it.
    const glm::dvec3& viewOrigin() const { return viewOrigin_; }
    /// Canonical eye space to world, the rotation or mirror only.
    const glm::dmat3& eyeToWorld() const { return eyeToWorld_; }
    /// Canonical.
    const glm::dmat4& projection() const { return projection_; }

    /// Whether lines of sight are parallel.
    bool orthographic() const { return projection_[2][3] == 0.0; }
    /// Whether nearer points have the larger clip depth.
    bool reversedDepth() const;
    /// A surface that the host's depth buffer shows.
    struct Surface {
        glm::dvec3 position; ///< relative to the eye, world axes
        glm::dvec3 viewer;   ///< unit vector towards the viewer, world axes
        double resolution;   ///< error bound of the distance, world units
        double footprint;    ///< that a pixel covers there, square on, world units
    };
    /// What shaders/frame/host_surface.glsl finds behind a pixel, in double precision.
    /// @param depth  as the depth buffer has it; not that of the background
    /// @param place  in the pixel, 0 to 1
    Surface surfaceAt(const glm::ivec2& pixel, double depth, const glm::ivec2& size,
                      const ClipConvention& clip, const glm::dvec2& place = glm::dvec2(0.5)) const;

    bool operator==(const HostCamera&) const = default;

    /// Sets the uniforms of shaders/frame/host_view.glsl.
    void setUniforms(gl::GLSLShader& shader, const glm::ivec2& size,
                     const ClipConvention& clip) const;

private:
    /// Values of the depth buffer as distances t along the view axis: with e = depth - far,
    /// t = (n0 + n1 e) / (d0 + d1 e).
    struct DepthRule {
        double far;          ///< value at the far end: nothing was drawn there
        glm::dvec4 toLinear; ///< n0 n1 d0 d1
    };
    DepthRule depthRule(const ClipConvention& clip) const;

    glm::dmat4 projection_{1.0};
    glm::dmat3 eyeToWorld_{1.0};
    glm::dvec3 eye_{0.0};
    glm::dvec3 viewOrigin_{0.0};
};

} // namespace aolib
