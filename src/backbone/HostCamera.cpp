#include "backbone/HostCamera.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace aolib {

namespace {

/// How far the axes of a view matrix may be from unit length and from right angles.
constexpr double kRigidTolerance = 1e-3;

bool isFinite(const glm::mat4& m) {
    for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) {
            if (!std::isfinite(m[c][r])) {
                return false;
            }
        }
    }
    return true;
}

bool isRigid(const glm::dmat3& m) {
    const glm::dmat3 gram = glm::transpose(m) * m;
    for (int c = 0; c < 3; ++c) {
        for (int r = 0; r < 3; ++r) {
            if (std::abs(gram[c][r] - (c == r ? 1.0 : 0.0)) > kRigidTolerance) {
                return false;
            }
        }
    }
    return true;
}

bool isPerspectiveOrOrthographic(const glm::dmat4& p) {
    const bool clean = p[0][1] == 0.0 && p[0][2] == 0.0 && p[0][3] == 0.0 && p[1][0] == 0.0 &&
                       p[1][2] == 0.0 && p[1][3] == 0.0;
    const bool perspective = p[2][3] != 0.0 && p[3][3] == 0.0;
    const bool orthographic = p[2][3] == 0.0 && p[3][3] != 0.0;
    return clean && p[0][0] != 0.0 && p[1][1] != 0.0 && (perspective || orthographic) &&
           (perspective ? p[3][2] : p[2][2]) != 0.0;
}

} // namespace

Result<HostCamera> HostCamera::create(const glm::mat4& view, const glm::mat4& projection) {
    if (!isFinite(view) || !isFinite(projection)) {
        return AoStatus(StatusCode::InvalidCamera, "the view or projection matrix is not finite");
    }
    const glm::dmat3 rotation{glm::dmat4(view)};
    if (!isRigid(rotation) || view[0][3] != 0.0F || view[1][3] != 0.0F || view[2][3] != 0.0F ||
        view[3][3] != 1.0F) {
        return AoStatus(StatusCode::InvalidCamera,
                        "the view matrix is no rotation and translation; keep scale and projection "
                        "out of it");
    }
    HostCamera camera;
    camera.projection_ = glm::dmat4(projection);
    if (!isPerspectiveOrOrthographic(camera.projection_)) {
        return AoStatus(StatusCode::InvalidCamera,
                        "the projection matrix is neither perspective nor orthographic");
    }
    camera.eyeToWorld_ = glm::inverse(rotation);
    camera.eye_ = -(camera.eyeToWorld_ * glm::dvec3(view[3]));
    return camera;
}

bool HostCamera::reversedDepth() const {
    // The sign of d ndc / d t, where ndc(t) = (-P22 t + P32) / (-P23 t + P33).
    const glm::dmat4& p = projection_;
    return p[3][2] * p[2][3] - p[2][2] * p[3][3] < 0.0;
}

HostCamera::DepthRule HostCamera::depthRule(const ClipConvention& clip) const {
    const glm::dmat4& p = projection_;
    const double nearest = clip.zeroToOne ? 0.0 : -1.0;
    const double ndcFar = reversedDepth() ? nearest : 1.0;
    const double slope = (1.0 - nearest) / (clip.depthRange[1] - clip.depthRange[0]);
    return {clip.depthRange[reversedDepth() ? 0 : 1],
            {p[3][2] - ndcFar * p[3][3], -slope * p[3][3], p[2][2] - ndcFar * p[2][3],
             -slope * p[2][3]}};
}

HostCamera::Surface HostCamera::surfaceAt(const glm::ivec2& pixel, double depth,
                                          const glm::ivec2& size, const ClipConvention& clip,
                                          const glm::dvec2& place) const {
    const glm::dmat4& p = projection_;
    const auto [far, rule] = depthRule(clip);
    const double e = depth - far;
    const double denominator = rule[2] + rule[3] * e;
    const double t = (rule[0] + rule[1] * e) / denominator;
    const double w = p[3][3] - p[2][3] * t;
    const double flip = clip.upperLeft ? -1.0 : 1.0;
    const glm::dvec2 ndc = (glm::dvec2(pixel) + place) / glm::dvec2(size) * 2.0 - 1.0;
    const glm::dvec3 eye((ndc.x * w + p[2][0] * t - p[3][0]) / p[0][0],
                         (flip * ndc.y * w + p[2][1] * t - p[3][1]) / p[1][1], -t);
    const glm::dvec3 viewer = p[2][3] == 0.0 ? glm::dvec3(0.0, 0.0, 1.0) : -glm::normalize(eye);
    return {eyeToWorld_ * eye, eyeToWorld_ * viewer,
            std::abs((rule[1] * rule[2] - rule[0] * rule[3]) / (denominator * denominator)) *
                clip.depthQuantum,
            std::abs(2.0 * w / p[1][1] / size.y)};
}

void HostCamera::setUniforms(gl::GLSLShader& shader, const glm::ivec2& size,
                             const ClipConvention& clip) const {
    const glm::dmat4& p = projection_;
    const DepthRule rule = depthRule(clip);
    const double flip = clip.upperLeft ? -1.0 : 1.0;
    shader.set("uViewSize", glm::vec2(size));
    shader.set("uDepthFar", static_cast<float>(rule.far));
    shader.set("uDepthQuantum", static_cast<float>(clip.depthQuantum));
    shader.set("uDepthToLinear", glm::vec4(rule.toLinear));
    shader.set("uClipToEye",
               glm::vec4(glm::dvec4(1.0 / p[0][0], flip / p[1][1], p[2][0], flip * p[2][1])));
    shader.set("uClipOffset", glm::vec4(glm::dvec4(p[3][0], flip * p[3][1], p[3][3], -p[2][3])));
    shader.set("uEyeToWorld", glm::mat3(eyeToWorld_));
}

} // namespace aolib
