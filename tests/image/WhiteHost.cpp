#include "WhiteHost.h"

#include <array>

#include <gtest/gtest.h>

namespace aolib::test {

WhiteHost::WhiteHost(const gl::Functions& gl, const Model& model) : gl_(gl) {
    const TriangleMesh all = model.flattened();
    vertices_ = std::move(
        *gl::VertexArray::createTriangles(gl, {all.positions, {}, {}, all.indices}, "host"));
    auto shader = gl::GLSLShader::build(
        gl,
        {"white.vert", "#version 330 core\nlayout(location = 0) in vec3 position;\n"
                       "uniform mat4 view;\nuniform mat4 projection;\n"
                       "void main() { gl_Position = projection * (view * vec4(position, 1)); }"},
        {"white.frag", "#version 330 core\nuniform float white;\nout vec4 colour;\n"
                       "void main() { colour = vec4(vec3(white), 1); }"});
    EXPECT_TRUE(shader.ok()) << shader.status().message();
    shader_ = std::move(*shader);
}

void WhiteHost::draw(const CameraKind& camera, float white) {
    const std::array<float, 4> sky{white, white, white, 1.0F};
    const double far = camera.reversed ? 0.0 : 1.0;
    const auto cleared = static_cast<float>(camera.depthRange[0] == 0.25 ? 0.5 : far);
    gl_.ClearBufferfv(GL_COLOR, 0, sky.data());
    gl_.ClearBufferfv(GL_DEPTH, 0, &cleared);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(camera.reversed ? GL_GREATER : GL_LESS);
    shader_.bind();
    shader_.set("view", glm::mat4(viewOf(camera)));
    shader_.set("projection", glm::mat4(camera.projection));
    shader_.set("white", white);
    vertices_.drawTriangles();
}

} // namespace aolib::test
