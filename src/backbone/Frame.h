#pragma once

#include <array>
#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/Options.h>

#include "backbone/HostCamera.h"
#include "gl/Functions.h"
#include "gl/VertexArray.h"
#include "scene/Scene.h"

namespace aolib {

/// What every pass needs for as long as an instance lives.
struct BackboneContext {
    const gl::Functions& gl;
    const gl::VertexArray& generated; ///< no attributes; covers the screen with one triangle
    Scene& scene;
    const Options& options;
    const std::unique_ptr<AbstractTexelTracer>& tracer; ///< empty: the host gave none
};

/// One frame as the host hands it over at aoDrawEnd().
struct Frame {
    HostCamera camera;
    glm::vec3 position; ///< of the camera, as the host gave it
    GLuint framebuffer; ///< the host's draw framebuffer
    glm::ivec2 origin;  ///< lower left corner of its viewport, pixels
    glm::ivec2 size;    ///< of its viewport, pixels
    ClipConvention clip;
    bool srgb;    ///< the host encodes colours when it writes them
    bool scissor; ///< the host's scissor test is on
};

} // namespace aolib
