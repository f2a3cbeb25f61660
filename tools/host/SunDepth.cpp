#include "host/SunDepth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "host/HostShaders.h"

namespace aolib::host {

Result<SunDepth> SunDepth::create(const gl::Functions& gl, int size) {
    SunDepth sun;
    sun.gl_ = &gl;
    Result<gl::GLSLShader> shader = gl::GLSLShader::build(
        gl, {"sun_depth.vert", sunDepthVertexShader}, {"sun_depth.frag", sunDepthFragmentShader});
    if (!shader) {
        return shader.status();
    }
    sun.shader_ = std::move(*shader);
    gl::RenderToTexture2D::Settings settings;
    settings.width = settings.height = size;
    settings.depth = gl::RenderToTexture2D::Depth::Depth32F;
    settings.label = "host/sun";
    Result<gl::RenderToTexture2D> map = gl::RenderToTexture2D::create(gl, settings);
    if (!map) {
        return map.status();
    }
    sun.map_ = std::move(*map);
    return sun;
}

void SunDepth::draw(const std::vector<LitMesh>& meshes, const Bounds& bounds,
                    const glm::vec3& direction) {
    const float reach = 0.5F * bounds.diagonal();
    const glm::vec3 up =
        std::abs(direction.y) > 0.9F ? glm::vec3(1.0F, 0.0F, 0.0F) : glm::vec3(0.0F, 1.0F, 0.0F);
    const glm::mat4 view =
        glm::lookAt(bounds.center() + 2.0F * reach * direction, bounds.center(), up);
    // No larger than the scene as the sun sees it.
    const Bounds seen = transformed(bounds, view);
    const float margin = 0.01F * reach;
    const glm::mat4 worldToClip =
        glm::orthoRH_NO(seen.min.x - margin, seen.max.x + margin, seen.min.y - margin,
                        seen.max.y + margin, -seen.max.z - margin, -seen.min.z + margin) *
        view;
    worldToMap_ = glm::translate(glm::mat4(1.0F), glm::vec3(0.5F)) *
                  glm::scale(glm::mat4(1.0F), glm::vec3(0.5F)) * worldToClip;
    texel_ = std::max(seen.max.x - seen.min.x, seen.max.y - seen.min.y) /
             static_cast<float>(map_.width());
    map_.bindAllAsTargets();
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->DepthMask(GL_TRUE);
    const float far = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &far);
    shader_.bind();
    shader_.set("worldToClip", worldToClip);
    for (const LitMesh& mesh : meshes) {
        mesh.draw();
    }
}

} // namespace aolib::host
