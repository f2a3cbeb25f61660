#include "HostKinds.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "SmallScene.h"

namespace aolib::test {

namespace {

constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
const glm::dvec3 kTarget{0.0, 0.5, 0.0};
/// Half the height of what an orthographic camera sees, and how many times as far away a
/// perspective one stands that sees nearly the same.
constexpr double kHalfHeight = 3.0;
constexpr double kAfar = 12.0;

/// Clip depth [-1,1] to [0,1], near to far.
glm::dmat4 toZeroToOne(const glm::dmat4& projection) {
    glm::dmat4 map(1.0);
    map[2][2] = 0.5;
    map[3][2] = 0.5;
    return map * projection;
}
/// Near becomes far.
glm::dmat4 reversed(const glm::dmat4& projection) {
    return glm::scale(glm::dmat4(1.0), {1.0, 1.0, -1.0}) * projection;
}
glm::dmat4 plain() {
    return glm::perspectiveRH_NO(glm::radians(60.0), kAspect, 0.5, 40.0);
}
glm::dmat4 infinite() {
    return glm::tweakedInfinitePerspective(glm::radians(60.0), kAspect, 0.5, 0.0);
}

} // namespace

std::map<std::string, CameraKind> cameraKinds() {
    std::map<std::string, CameraKind> kinds;
    const auto add = [&](const char* name, const glm::dmat4& traced) -> CameraKind& {
        kinds[name] = {.projection = traced, .traced = traced};
        return kinds[name];
    };
    add("perspective", plain());
    add("off-centre", glm::frustumRH_NO(-0.8, 0.3, -0.2, 0.35, 0.6, 40.0));
    add("orthographic", glm::orthoRH_NO(-kHalfHeight * kAspect, kHalfHeight * kAspect, -kHalfHeight,
                                        kHalfHeight, 0.5, 40.0))
        .like = "perspective from afar";
    const double away = kAfar * glm::distance(kEye, kTarget);
    add("perspective from afar", glm::perspectiveRH_NO(2.0 * std::atan(kHalfHeight / away), kAspect,
                                                       away - 10.0, away + 20.0))
        .distance = kAfar;
    kinds["perspective from afar"].like = "perspective from afar";
    add("infinite far", infinite());
    CameraKind& backwards = add("reversed", plain());
    backwards.projection = reversed(plain());
    backwards.reversed = true;
    CameraKind& modern = add("reversed, [0,1], infinite far", infinite());
    modern.projection = toZeroToOne(reversed(infinite()));
    modern.reversed = modern.zeroToOne = true;
    CameraKind& direct = add("[0,1]", plain());
    direct.projection = toZeroToOne(plain());
    direct.zeroToOne = true;
    add("upper left", plain()).upperLeft = true;
    kinds["upper left"].mirrored = true;
    CameraKind& flipped = add("y flipped", plain());
    flipped.projection[1][1] *= -1.0;
    flipped.mirrored = true;
    CameraKind& range = add("depth range reversed", plain());
    range.depthRange = {1.0, 0.0};
    range.reversed = true;
    add("depth range within", plain()).depthRange = {0.25, 0.5};
    for (const char* name : {"perspective", "off-centre", "orthographic", "y flipped",
                             "reversed, [0,1], infinite far", "depth range reversed"}) {
        kinds[std::string("left-handed, ") + name] = leftHanded(kinds[name], 0.5);
    }
    return kinds;
}

CameraKind leftHanded(CameraKind camera, double scale) {
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1.0), {1.0, 1.0, -1.0});
    camera.projection = scale * camera.projection * mirror;
    camera.turn = mirror * camera.turn;
    return camera;
}

std::map<std::string, FramebufferKind> framebufferKinds() {
    return {
        {"16 bits of depth", {.depth = GL_DEPTH_COMPONENT16}},
        {"floating-point depth texture", {.depth = GL_DEPTH_COMPONENT32F, .depthTexture = true}},
        {"2 samples", {.samples = 2}},
        {"4 samples", {.samples = 4}},
        {"8 samples", {.samples = 8}},
        {"sRGB", {.colour = GL_SRGB8_ALPHA8}},
        {"HDR", {.colour = GL_RGBA16F, .white = 6.0F}},
        {"ten bits", {.colour = GL_RGB10_A2}},
        {"sub-viewport", {.origin = {17, 9}}},
        {"sub-viewport, scissored", {.origin = {17, 9}, .scissor = true}},
        {"resized", {.resized = true}},
        {"own textures", {.depthTexture = true, .textures = true}}};
}

Model boxes() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    addBox(model, {-2, 0, -2}, {0, 2, 0});
    addBox(model, {0.5F, 0, -1}, {2, 1, 1});
    addBox(model, {-1, 0, 1}, {0, 0.5F, 2.5F});
    return model;
}

glm::dvec3 eyeOf(const CameraKind& camera) {
    return kTarget + camera.distance * (kEye - kTarget);
}
glm::dmat4 viewOf(const CameraKind& camera) {
    return camera.turn * glm::lookAt(eyeOf(camera), kTarget, glm::dvec3(0.0, 1.0, 0.0));
}

} // namespace aolib::test
