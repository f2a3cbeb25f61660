#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include <aolib/Status.h>

#include "content/Model.h"
#include "gl/GLSLShader.h"
#include "gl/Handle.h"
#include "host/HostMesh.h"

namespace aolib::host {

/// Draws a model as an ordinary renderer would: Lambert under sky and sun, a background, its own
/// shaders and vertex arrays. Knows nothing of ambient occlusion, and touches only the state that
/// it needs, as hosts do. Context: the one current at create(), for every call.
class HostRenderer {
public:
    /// Uploads the model. @param gl  must outlive the renderer.
    /// Errors: ShaderError, OutOfMemory.
    static Result<HostRenderer> create(const gl::Functions& gl, const Model& model);

    /// Clears what is bound and draws background and model into it, over the current viewport.
    /// @param view,projection  world to eye, eye to clip; any that OpenGL can draw.
    void draw(const glm::mat4& view, const glm::mat4& projection);

private:
    void drawSky(const glm::mat4& view, const glm::mat4& projection);
    void drawMeshes(const glm::mat4& view, const glm::mat4& projection);

    const gl::Functions* gl_ = nullptr;
    gl::GLSLShader surface_;
    gl::GLSLShader sky_;
    gl::VertexArrayName empty_; ///< for the sky, whose vertices need no data
    std::vector<HostMesh> meshes_;
};

} // namespace aolib::host
