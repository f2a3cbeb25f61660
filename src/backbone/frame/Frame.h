#pragma once

#include <array>
#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/Options.h>
#include <aolib/SceneRenderer.h>
#include <aolib/ViewId.h>

#include "backbone/frame/HostCamera.h"
#include "gl/Functions.h"
#include "gl/VertexArray.h"
#include "scene/Scene.h"

namespace aolib {

/// What every pass needs for as long as an instance lives.
struct BackboneContext {
    const gl::Functions& gl;
    const gl::VertexArray& emptyVertexArray; ///< no attributes; covers the screen with one triangle
    Scene& scene;
    const Options& options;
    const std::unique_ptr<AbstractTexelTracer>& tracer; ///< empty: the host gave none
    const SceneRenderer& renderer;                      ///< empty: triangles are drawn
};

/// One frame as the host hands it over at aoDrawEnd().
struct Frame {
    HostCamera camera;
    glm::vec3 position;          ///< of the camera, as the host gave it
    GLuint framebuffer = 0;      ///< of the host's colours
    GLuint depthFramebuffer = 0; ///< of the host's depth
    glm::ivec2 origin{0};        ///< lower left corner of its viewport, pixels
    glm::ivec2 size{0};          ///< of its viewport, pixels
    ClipConvention clip;
    bool srgb = false;        ///< the host encodes colours when it writes them
    bool scissor = false;     ///< the host's scissor test is on
    ViewId view{};            ///< that it belongs to
    bool hostNormals = false; ///< colour 0 of that framebuffer holds the host's normals
};

} // namespace aolib
