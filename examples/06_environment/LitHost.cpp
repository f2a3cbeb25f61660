#include "LitHost.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "Stage.h"

namespace {

const char* const kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 open;
uniform mat4 worldToClip;
out vec3 worldNormal;
out vec4 opening;
out vec3 base;
void main() {
    worldNormal = normal;
    opening = open;
    bool ground = position.y == 0.0 && normal.y > 0.0;
    base = ground ? vec3(0.70, 0.67, 0.60) : vec3(0.84, 0.48, 0.23);
    gl_Position = worldToClip * vec4(position, 1.0);
})";

const char* const kFragmentShader = R"(
in vec3 worldNormal;
in vec4 opening;
in vec3 base;
uniform sampler2DArray cones;
out vec4 colour;
void main() {
    vec3 light = aoConeLight(cones, normalize(worldNormal), normalize(opening.xyz), opening.w);
    colour = vec4(pow(base * light, vec3(1.0 / 2.2)), 1.0);
})";

void attribute(GLuint location, int components, const float* values, std::size_t count) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(float)), values,
                 GL_STATIC_DRAW);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(location);
}

using Corner = std::pair<glm::vec3, glm::vec3>; ///< position, normal

void cut(Triangles& fine, const std::array<Corner, 3>& corner, float longest) {
    std::size_t first = 0;
    float length = 0.0F;
    for (std::size_t i = 0; i < 3; ++i) {
        const float edge = glm::distance(corner[i].first, corner[(i + 1) % 3].first);
        if (edge > length) {
            length = edge;
            first = i;
        }
    }
    if (length <= longest) {
        for (const Corner& vertex : corner) {
            fine.indices.push_back(static_cast<std::uint32_t>(fine.positions.size()));
            fine.positions.push_back(vertex.first);
            fine.normals.push_back(vertex.second);
        }
        return;
    }
    const Corner& a = corner[first];
    const Corner& b = corner[(first + 1) % 3];
    const Corner& c = corner[(first + 2) % 3];
    const Corner middle{0.5F * (a.first + b.first), a.second};
    cut(fine, {a, middle, c}, longest);
    cut(fine, {middle, b, c}, longest);
}

} // namespace

Triangles cutFine(const Triangles& coarse, float longest) {
    Triangles fine;
    for (std::size_t i = 0; i < coarse.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            const std::uint32_t vertex = coarse.indices[i + k];
            return Corner{coarse.positions[vertex], coarse.normals[vertex]};
        };
        cut(fine, {corner(0), corner(1), corner(2)}, longest);
    }
    return fine;
}

LitHost::LitHost(const Triangles& scene, const std::vector<glm::vec4>& open,
                 std::string_view functions)
    : program_(glCreateProgram()), indexCount_(static_cast<GLsizei>(scene.indices.size())) {
    const std::string fragment = "#version 330 core\n" + std::string(functions) + kFragmentShader;
    for (const auto& [kind, source] : {std::pair{GL_VERTEX_SHADER, kVertexShader},
                                       std::pair{GL_FRAGMENT_SHADER, fragment.c_str()}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program_, shader);
    }
    glLinkProgram(program_);
    GLint linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (linked == 0) {
        std::array<char, 1024> log{};
        glGetProgramInfoLog(program_, log.size(), nullptr, log.data());
        throw std::runtime_error(log.data());
    }
    glGenVertexArrays(1, &vertices_);
    glBindVertexArray(vertices_);
    attribute(0, 3, glm::value_ptr(scene.positions[0]), 3 * scene.positions.size());
    attribute(1, 3, glm::value_ptr(scene.normals[0]), 3 * scene.normals.size());
    attribute(2, 4, glm::value_ptr(open[0]), 4 * open.size());
    GLuint indices = 0;
    glGenBuffers(1, &indices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(scene.indices.size() * sizeof(std::uint32_t)),
                 scene.indices.data(), GL_STATIC_DRAW);
}

void LitHost::draw(const glm::mat4& worldToClip, GLuint cones) const {
    glViewport(0, 0, stage::kWidth, stage::kHeight);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.60F, 0.72F, 0.86F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program_);
    glUniformMatrix4fv(glGetUniformLocation(program_, "worldToClip"), 1, GL_FALSE,
                       glm::value_ptr(worldToClip));
    glActiveTexture(GL_TEXTURE0); // the unit that samplers read unless told otherwise
    glBindTexture(GL_TEXTURE_2D_ARRAY, cones);
    glBindVertexArray(vertices_);
    glDrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

std::vector<std::uint8_t> LitHost::read() {
    std::vector<std::uint8_t> rgb(3U * stage::kWidth * stage::kHeight);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, stage::kWidth, stage::kHeight, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    return rgb;
}
