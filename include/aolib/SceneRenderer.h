#pragma once

#include <functional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// The camera of one face of a cube map, at the cube map's centre. Clip space is OpenGL's default:
/// depth in [-1,1], the nearest smallest, the origin at the lower left.
struct FaceView {
    glm::mat4 view;       ///< world to eye
    glm::mat4 projection; ///< eye to clip, 90 degrees
    glm::vec3 position;   ///< of the camera, world units
    glm::ivec2 size;      ///< of the viewport, pixels
};

/// Draws the occluders of one face with the host's draw calls and shaders. Only depth is used.
/// On entry a cleared framebuffer with only a depth attachment is bound, and the viewport covers
/// the framebuffer. Depth test and depth writes are on; culling, blending and other tests are off.
/// Program, vertex array and textures are unspecified.
///
/// State listed in the table of docs/integration.md need not be restored.
/// Before the callback returns, end queries, transform feedback, conditional rendering and debug
/// groups, and make the original context current.
/// Errors: calls to the same instance within the callback return InvalidCallOrder. An exception
/// ends the outer call with CallbackFailed.
using SceneRenderer = std::function<void(const FaceView&)>;

} // namespace aolib
