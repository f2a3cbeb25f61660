#include "Renderer.h"

#include <array>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <glm/gtc/type_ptr.hpp>

namespace {

const char* const kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 worldToClip;
out vec3 shade;
void main() {
    float light = 0.62 + 0.38 * dot(normal, normalize(vec3(0.4, 0.8, 0.3)));
    bool ground = position.y == 0.0 && normal.y > 0.0;
    shade = light * (ground ? vec3(0.86, 0.84, 0.80) : vec3(0.93, 0.72, 0.52));
    gl_Position = worldToClip * vec4(position, 1.0);
})";

const char* const kFragmentShader = R"(#version 330 core
in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, 1.0); })";

} // namespace

Renderer::Renderer(Display::GetProcAddress load, const Triangles& scene, int width, int height)
    : gl_(loadFunctions(load)), indexCount_(static_cast<GLsizei>(scene.indices.size())),
      width_(width), height_(height) {
    buildShader();
    upload(scene);
}

Renderer::Functions Renderer::loadFunctions(Display::GetProcAddress load) {
    const auto get = [load](const char* name, auto& function) {
        void* address = load(name);
        std::memcpy(&function, &address, sizeof(function));
    };
    Functions gl{};
    get("glAttachShader", gl.attachShader);
    get("glBindBuffer", gl.bindBuffer);
    get("glBindVertexArray", gl.bindVertexArray);
    get("glBufferData", gl.bufferData);
    get("glClear", gl.clear);
    get("glClearColor", gl.clearColor);
    get("glCompileShader", gl.compileShader);
    get("glCreateProgram", gl.createProgram);
    get("glCreateShader", gl.createShader);
    get("glDrawElements", gl.drawElements);
    get("glEnable", gl.enable);
    get("glEnableVertexAttribArray", gl.enableVertexAttribArray);
    get("glGenBuffers", gl.genBuffers);
    get("glGenVertexArrays", gl.genVertexArrays);
    get("glGetProgramInfoLog", gl.getProgramInfoLog);
    get("glGetProgramiv", gl.getProgramiv);
    get("glGetUniformLocation", gl.getUniformLocation);
    get("glLinkProgram", gl.linkProgram);
    get("glPixelStorei", gl.pixelStorei);
    get("glReadPixels", gl.readPixels);
    get("glShaderSource", gl.shaderSource);
    get("glUniformMatrix4fv", gl.uniformMatrix4fv);
    get("glUseProgram", gl.useProgram);
    get("glVertexAttribPointer", gl.vertexAttribPointer);
    get("glViewport", gl.viewport);
    return gl;
}

void Renderer::buildShader() {
    program_ = gl_.createProgram();
    for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, kVertexShader},
                                       std::pair{GL_FRAGMENT_SHADER, kFragmentShader}}) {
        const GLuint shader = gl_.createShader(static_cast<GLenum>(kind));
        gl_.shaderSource(shader, 1, &source, nullptr);
        gl_.compileShader(shader);
        gl_.attachShader(program_, shader);
    }
    gl_.linkProgram(program_);
    GLint linked = 0;
    gl_.getProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::array<char, 1024> log{};
        gl_.getProgramInfoLog(program_, log.size(), nullptr, log.data());
        throw std::runtime_error(log.data());
    }
    worldToClip_ = gl_.getUniformLocation(program_, "worldToClip");
}

void Renderer::upload(const Triangles& scene) {
    gl_.genVertexArrays(1, &vertices_);
    gl_.bindVertexArray(vertices_);
    uploadAttribute(0, scene.positions);
    uploadAttribute(1, scene.normals);
    GLuint indices = 0;
    gl_.genBuffers(1, &indices);
    gl_.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    gl_.bufferData(GL_ELEMENT_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(scene.indices.size() * sizeof(std::uint32_t)),
                   scene.indices.data(), GL_STATIC_DRAW);
}

void Renderer::uploadAttribute(GLuint location, const std::vector<glm::vec3>& values) const {
    GLuint buffer = 0;
    gl_.genBuffers(1, &buffer);
    gl_.bindBuffer(GL_ARRAY_BUFFER, buffer);
    gl_.bufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(glm::vec3)),
                   values.data(), GL_STATIC_DRAW);
    gl_.vertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl_.enableVertexAttribArray(location);
}

void Renderer::draw(const glm::mat4& view, const glm::mat4& projection) const {
    gl_.viewport(0, 0, width_, height_);
    gl_.enable(GL_DEPTH_TEST);
    gl_.clearColor(0.60F, 0.72F, 0.86F, 1.0F);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.useProgram(program_);
    gl_.uniformMatrix4fv(worldToClip_, 1, GL_FALSE, glm::value_ptr(projection * view));
    gl_.bindVertexArray(vertices_);
    gl_.drawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

bool Renderer::save(const std::string& path) const {
    const auto row = static_cast<std::size_t>(3 * width_);
    std::vector<char> pixels(row * static_cast<std::size_t>(height_));
    gl_.pixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.readPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width_ << ' ' << height_ << "\n255\n";
    for (auto y = static_cast<std::size_t>(height_); y-- > 0;) {
        file.write(pixels.data() + y * row, static_cast<std::streamsize>(row));
    }
    return static_cast<bool>(file.flush());
}
