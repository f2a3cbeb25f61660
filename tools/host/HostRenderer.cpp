#include "host/HostRenderer.h"

#include <array>
#include <utility>

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/matrix.hpp>

#include "host/HostShaders.h"

namespace aolib::host {

namespace {

/// World space, towards the light: over the viewer's shoulder for most of our cameras.
const glm::vec3 kLightDirection = glm::normalize(glm::vec3(0.45F, 0.80F, 0.40F));
const glm::vec3 kUpDirection{0.0F, 1.0F, 0.0F};
constexpr std::array<float, 4> kBlack{0.0F, 0.0F, 0.0F, 1.0F};

} // namespace

Result<HostRenderer> HostRenderer::create(const gl::Functions& gl, const Model& model) {
    HostRenderer renderer;
    renderer.gl_ = &gl;
    Result<gl::GLSLShader> surface = gl::GLSLShader::build(
        gl, {"surface.vert", surfaceVertexShader}, {"surface.frag", surfaceFragmentShader});
    if (!surface) {
        return surface.status();
    }
    renderer.surface_ = std::move(*surface);
    Result<gl::GLSLShader> sky =
        gl::GLSLShader::build(gl, {"sky.vert", skyVertexShader}, {"sky.frag", skyFragmentShader});
    if (!sky) {
        return sky.status();
    }
    renderer.sky_ = std::move(*sky);
    renderer.empty_ = gl::generate<gl::VertexArrayName>(gl, &gl::Functions::GenVertexArrays);
    for (const ModelMesh& mesh : model.meshes) {
        if (mesh.indices.empty()) {
            continue;
        }
        Result<HostMesh> uploaded = HostMesh::create(gl, mesh);
        if (!uploaded) {
            return uploaded.status();
        }
        renderer.meshes_.push_back(std::move(*uploaded));
    }
    return renderer;
}

void HostRenderer::draw(const glm::mat4& view, const glm::mat4& projection) {
    gl_->Disable(GL_BLEND);
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_STENCIL_TEST);
    gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_->DepthMask(GL_TRUE);
    gl_->ClearBufferfv(GL_COLOR, 0, kBlack.data());
    gl_->ClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0F, 0);
    drawSky(view, projection);
    drawMeshes(view, projection);
    gl_->BindVertexArray(0);
    gl_->UseProgram(0);
}

void HostRenderer::drawSky(const glm::mat4& view, const glm::mat4& projection) {
    gl_->Disable(GL_DEPTH_TEST);
    sky_.bind();
    sky_.set("inverseProjection", glm::inverse(projection));
    sky_.set("eyeToWorld", glm::inverse(glm::mat3(view)));
    gl_->BindVertexArray(empty_.name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void HostRenderer::drawMeshes(const glm::mat4& view, const glm::mat4& projection) {
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    surface_.bind();
    surface_.set("projection", projection);
    surface_.set("perspective", projection[3][3] == 0.0F ? 1 : 0);
    surface_.set("lightDirection", glm::mat3(view) * kLightDirection);
    surface_.set("upDirection", glm::mat3(view) * kUpDirection);
    for (const HostMesh& mesh : meshes_) {
        const glm::mat4 modelView(glm::dmat4(view) * glm::dmat4(mesh.transform()));
        surface_.set("modelView", modelView);
        surface_.set("normalMatrix", glm::inverseTranspose(glm::mat3(modelView)));
        surface_.set("baseColour", mesh.colour());
        surface_.set("hasNormals", mesh.hasNormals() ? 1 : 0);
        mesh.draw();
    }
}

} // namespace aolib::host
