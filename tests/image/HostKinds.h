#pragma once

#include <array>
#include <map>
#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "content/Model.h"
#include "gl/Functions.h"

namespace aolib::test {

inline constexpr int kWidth = 240;
inline constexpr int kHeight = 136;
/// Where the cube map stands, and the eye of all cameras but those from afar.
inline const glm::dvec3 kEye{4.0, 4.0, 6.0};

/// A projection, the one that shows the same pixels to the tracer, and what GL must be told.
struct CameraKind {
    glm::dmat4 projection{1.0};
    glm::dmat4 traced{1.0};
    glm::dmat4 turn{1.0}; ///< of eye space, after what looks along -z with y up
    bool zeroToOne = false;
    bool upperLeft = false;
    bool reversed = false;
    bool mirrored = false;            ///< rows of the picture run downwards
    double distance = 1.0;            ///< of the eye from the target, as multiples of kEye's
    std::string like = "perspective"; ///< the plain camera that sees the same
    std::array<double, 2> depthRange{0.0, 1.0};
};

struct FramebufferKind {
    GLenum colour = GL_RGBA8;
    GLenum depth = GL_DEPTH24_STENCIL8;
    int samples = 0;
    bool depthTexture = false;
    float white = 1.0F;    ///< what the host draws
    glm::ivec2 origin{0};  ///< of the viewport; the framebuffer is larger by twice that
    bool scissor = false;  ///< around the viewport
    bool textures = false; ///< by aoApply
    bool resized = false;  ///< after a frame of another size
    bool window = false;   ///< framebuffer 0, as the context has it
};

/// By name; "perspective" is the plain one.
std::map<std::string, CameraKind> cameraKinds();
/// The same view, to the bit, with z away from the eye and a projection scaled as a whole.
CameraKind leftHanded(CameraKind camera, double scale = 1.0);
/// By name; a default one is the plain one.
std::map<std::string, FramebufferKind> framebufferKinds();

glm::dvec3 eyeOf(const CameraKind& camera);
glm::dmat4 viewOf(const CameraKind& camera);

/// What all of them see.
Model boxes();

} // namespace aolib::test
