#include "backbone/frame/HostCamera.h"

#include <algorithm>
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

/// Cosine of the angle that the rows of a projection may be off the right angle between x and y.
constexpr double kSkewTolerance = 1e-5;
/// An orthographic range of depth lies to one side of the eye if less than this share of it lies
/// to the other.
constexpr double kOneSided = 0.05;

AoStatus invalid(const char* what) {
    return {StatusCode::InvalidCamera, what};
}

/// Whether the projection is one of those that a canonical one is equivalent to.
AoStatus checkProjection(const glm::dmat4& p) {
    if (p[0][3] != 0.0 || p[1][3] != 0.0 || (p[2][3] == 0.0 && p[3][3] == 0.0)) {
        return invalid("the projection matrix is neither perspective nor orthographic: clip w must "
                       "depend on eye z alone, or on nothing");
    }
    if (p[0][2] != 0.0 || p[1][2] != 0.0) {
        return invalid("the projection matrix has an oblique near plane: clip z must depend on eye "
                       "z alone; draw with an upright one, and clip by gl_ClipDistance");
    }
    if (p[2][3] == 0.0 && p[3][3] < 0.0) {
        return invalid("the projection matrix shows nothing: clip w is negative everywhere; "
                       "negate the matrix");
    }
    const glm::dvec2 x(p[0][0], p[1][0]);
    const glm::dvec2 y(p[0][1], p[1][1]);
    const double lengths = glm::length(x) * glm::length(y);
    if (!(lengths > 0.0) || p[2][2] * p[3][3] == p[3][2] * p[2][3]) {
        return invalid("the projection matrix flattens what it shows: an axis has no extent");
    }
    if (std::abs(glm::dot(x, y)) > kSkewTolerance * lengths) {
        return invalid("the projection matrix is skewed: its x and y axes must be at right angles");
    }
    return {};
}

/// Projection P and a rigid transform T of eye space.
struct Decomposed {
    glm::dmat4 projection;
    glm::dmat3 rotation;   ///< of T: what its result is turned, or mirrored, by
    glm::dvec3 shift{0.0}; ///< of T: added before
};

/// A checked projection as P T: P is canonical, T what else the matrix does.
Decomposed decompose(glm::dmat4 p) {
    const bool perspective = p[2][3] != 0.0;
    p /= perspective ? std::abs(p[2][3]) : p[3][3];
    const glm::dvec2 x(p[0][0], p[1][0]);
    const glm::dvec2 y(p[0][1], p[1][1]);
    const double width = glm::length(x);
    const double height = glm::length(y);
    const double z = p[2][3] > 0.0 ? -1.0 : 1.0;
    glm::dvec3 shift(0.0);
    if (perspective) { // to where w and, there, clip x and y are zero: the centre of projection
        shift.z = p[3][3] / p[2][3];
        const glm::dvec2 offset = glm::dvec2(p[3]) - shift.z * glm::dvec2(p[2]);
        const glm::dvec2 turned(offset.x / width, offset.y / height);
        shift.x = (turned.x * x.x / width + turned.y * y.x / height);
        shift.y = (turned.x * x.y / width + turned.y * y.y / height);
        p[3] = glm::dvec4(0.0, 0.0, p[3][2] - shift.z * p[2][2], 0.0);
    }
    p[0] = glm::dvec4(width, 0.0, 0.0, 0.0);
    p[1] = glm::dvec4(0.0, height, 0.0, 0.0);
    p[2] *= z;
    return {p,
            glm::dmat3({x.x / width, y.x / height, 0.0}, {x.y / width, y.y / height, 0.0},
                       {0.0, 0.0, z}),
            shift};
}

} // namespace

Result<HostCamera> HostCamera::create(const glm::mat4& view, const glm::mat4& projection) {
    if (!isFinite(view) || !isFinite(projection)) {
        return invalid("the view or projection matrix is not finite");
    }
    const glm::dmat3 rotation{glm::dmat4(view)};
    if (!isRigid(rotation) || view[0][3] != 0.0F || view[1][3] != 0.0F || view[2][3] != 0.0F ||
        view[3][3] != 1.0F) {
        return invalid("the view matrix is no rotation and translation; keep scale and projection "
                       "out of it");
    }
    if (AoStatus status = checkProjection(glm::dmat4(projection)); !status) {
        return status;
    }
    const Decomposed canonical = decompose(glm::dmat4(projection));
    const glm::dmat3 viewToWorld = glm::inverse(rotation);
    HostCamera camera;
    camera.projection_ = canonical.projection;
    camera.eyeToWorld_ = viewToWorld * glm::transpose(canonical.rotation);
    camera.viewOrigin_ = -(viewToWorld * glm::dvec3(view[3]));
    camera.eye_ = camera.viewOrigin_ - viewToWorld * canonical.shift;
    return camera;
}

Result<HostCamera> HostCamera::under(const ClipConvention& clip, bool greaterIsNearer) const {
    const glm::dmat4& p = projection_;
    const double nearest = clip.zeroToOne ? 0.0 : -1.0;
    if (p[2][3] != 0.0) {
        // ndc(t) = -P22 + P32 / t, for t > 0: from one infinity to -P22.
        const bool shows = p[3][2] < 0.0 ? -p[2][2] > nearest : -p[2][2] < 1.0;
        if (!shows) {
            return invalid("the projection matrix shows nothing: where clip w is positive, clip z "
                           "is beyond the near or the far plane; its sign, or glClipControl's "
                           "depth mode, may be wrong");
        }
        return *this;
    }
    // ndc(t) = P32 - P22 t
    const double begin = (p[3][2] - nearest) / p[2][2];
    const double end = (p[3][2] - 1.0) / p[2][2];
    const double before = std::max(std::max(begin, end), 0.0);
    const double behind = std::max(-std::min(begin, end), 0.0);
    const bool rangeReversed = clip.depthRange[0] > clip.depthRange[1];
    const bool backwards = std::min(before, behind) < kOneSided * (before + behind)
                               ? behind > before
                               : reversedDepth() != (greaterIsNearer != rangeReversed);
    if (!backwards) {
        return *this;
    }
    HostCamera turned = *this;
    turned.projection_[2] = -p[2];
    turned.eyeToWorld_[2] = -eyeToWorld_[2];
    return turned;
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
    const glm::dvec3 viewer =
        orthographic() ? glm::normalize(glm::dvec3(-p[2][0] / p[0][0], -p[2][1] / p[1][1], 1.0))
                       : -glm::normalize(eye);
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
