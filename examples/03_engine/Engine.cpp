#include "Engine.h"

#include <array>
#include <stdexcept>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

namespace {

const char* const kGeometryVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 worldToClip;
out vec3 albedo;
out vec3 worldNormal;
void main() {
    bool ground = position.y == 0.0 && normal.y > 0.0;
    albedo = ground ? vec3(0.86, 0.84, 0.80) : vec3(0.93, 0.72, 0.52);
    worldNormal = normal;
    gl_Position = worldToClip * vec4(position, 1.0);
})";

const char* const kGeometryFragment = R"(#version 330 core
in vec3 albedo;
in vec3 worldNormal;
layout(location = 0) out vec4 outAlbedo;
layout(location = 1) out vec4 outNormal;
void main() {
    outAlbedo = vec4(albedo, 1.0);
    outNormal = vec4(normalize(worldNormal) * 0.5 + 0.5, 1.0);
})";

const char* const kLightVertex = R"(#version 330 core
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); })";

const char* const kLightFragment = R"(#version 330 core
uniform sampler2D albedo;
uniform sampler2D normal;
uniform sampler2D depth;
uniform sampler2D indirect;
out vec4 colour;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 n = texelFetch(normal, pixel, 0).xyz * 2.0 - 1.0;
    float sun = 0.45 * max(dot(n, normalize(vec3(0.4, 0.8, 0.3))), 0.0);
    float sky = (0.4 + 0.15 * n.y) * texelFetch(indirect, pixel, 0).r;
    vec3 lit = texelFetch(albedo, pixel, 0).rgb * (sun + sky);
    bool background = texelFetch(depth, pixel, 0).r == 1.0;
    colour = vec4(background ? vec3(0.60, 0.72, 0.86) : lit, 1.0);
})";

} // namespace

Engine::Engine(const Triangles& scene, int width, int height)
    : width_(width), height_(height), count_(static_cast<GLsizei>(scene.indices.size())) {
    upload(scene);
    glGenVertexArrays(1, &empty_);
    const std::uint8_t one = 255;
    const std::vector<std::uint8_t> ones(static_cast<std::size_t>(width * height), one);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    albedo_ = texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height, nullptr);
    normal_ = texture(GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_BYTE, width, height, nullptr);
    depth_ = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height, nullptr);
    white_ = texture(GL_R8, GL_RED, GL_UNSIGNED_BYTE, width, height, ones.data());
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, albedo_, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, normal_, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
    const std::array<GLenum, 2> both{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glDrawBuffers(2, both.data());
    geometryProgram_ = build(kGeometryVertex, kGeometryFragment);
    lightProgram_ = build(kLightVertex, kLightFragment);
}

GLuint Engine::build(const char* vertex, const char* fragment) {
    const GLuint program = glCreateProgram();
    for (const auto& [kind, source] :
         {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::array<char, 1024> log{};
        glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw std::runtime_error(log.data());
    }
    return program;
}

GLuint Engine::texture(GLenum internalFormat, GLenum format, GLenum type, int width, int height,
                       const void* data) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format,
                 type, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

void Engine::upload(const Triangles& scene) {
    glGenVertexArrays(1, &vertices_);
    glBindVertexArray(vertices_);
    GLuint location = 0;
    for (const auto* values : {&scene.positions, &scene.normals}) {
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values->size() * sizeof(glm::vec3)),
                     values->data(), GL_STATIC_DRAW);
        glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(location++);
    }
    GLuint indices = 0;
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(scene.indices.size() * sizeof(std::uint32_t)),
                 scene.indices.data(), GL_STATIC_DRAW);
}

void Engine::drawGeometry(const glm::mat4& view, const glm::mat4& projection) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(geometryProgram_);
    glUniformMatrix4fv(glGetUniformLocation(geometryProgram_, "worldToClip"), 1, GL_FALSE,
                       glm::value_ptr(projection * view));
    glBindVertexArray(vertices_);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void Engine::light(GLuint indirect) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(lightProgram_);
    GLint unit = 0;
    for (const auto& [name, texture] :
         {std::pair{"albedo", albedo_}, std::pair{"normal", normal_}, std::pair{"depth", depth_},
          std::pair{"indirect", indirect}}) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D, texture);
        glUniform1i(glGetUniformLocation(lightProgram_, name), unit++);
    }
    glBindVertexArray(empty_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

std::vector<std::uint8_t> Engine::read() const {
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width_ * height_));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    return rgb;
}
