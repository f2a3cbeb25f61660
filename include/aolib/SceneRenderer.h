#pragma once

#include <functional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace aolib {

/// A camera at a cube map's centre that looks through one of its faces. Depth is [-1,1] in clip
/// space, the nearest is the smallest, the origin lower left, as OpenGL begins with.
struct FaceView {
    glm::mat4 view;       ///< world to eye
    glm::mat4 projection; ///< eye to clip, 90 degrees
    glm::vec3 position;   ///< of the camera, world units
    glm::ivec2 size;      ///< of the viewport, pixels
};

/// Draws what occludes as a face sees it: the host's own draw calls and shaders. Depth is all that
/// counts. On entry a framebuffer with depth alone is bound and cleared, the viewport covers it,
/// and depth test and writes are on; culling, blending and other tests are off. Program, vertex
/// array and textures are unspecified.
///
/// State of the table in docs/integration.md need not be put back. What a guest cannot put back
/// must be ended before the callback returns: queries, transform feedback, conditional rendering,
/// debug groups; and the context that was current must be so again. Calls to the same instance are
/// refused meanwhile (InvalidCallOrder); an exception ends the call with CallbackFailed.
using SceneRenderer = std::function<void(const FaceView&)>;

} // namespace aolib
