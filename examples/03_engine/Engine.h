#pragma once

#include <cstdint>
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/mat4x4.hpp>

#include "Boxes.h"

/// A deferred renderer: geometry to textures of its own first, light after that. Knows nothing of
/// aolib; what the indirect light is multiplied by is a texture like any other.
/// Throws std::runtime_error with the driver's log when a shader does not build.
class Engine {
public:
    Engine(const Triangles& scene, int width, int height);

    /// Fills albedo, normal and depth.
    void drawGeometry(const glm::mat4& view, const glm::mat4& projection) const;
    /// Lights framebuffer 0 by sun and sky. @param indirect  factor of the sky's light, in red.
    void light(GLuint indirect) const;
    /// RGB bytes of framebuffer 0, the bottom row first.
    std::vector<std::uint8_t> read() const;

    GLuint depth() const { return depth_; }
    GLuint normal() const { return normal_; }
    GLuint white() const { return white_; } ///< a factor of 1

private:
    static GLuint build(const char* vertex, const char* fragment);
    static GLuint texture(GLenum internalFormat, GLenum format, GLenum type, int width, int height,
                          const void* data);
    void upload(const Triangles& scene);

    int width_;
    int height_;
    GLsizei count_;
    GLuint vertices_ = 0;
    GLuint empty_ = 0;
    GLuint albedo_ = 0;
    GLuint normal_ = 0;
    GLuint depth_ = 0;
    GLuint white_ = 0;
    GLuint framebuffer_ = 0;
    GLuint geometryProgram_ = 0;
    GLuint lightProgram_ = 0;
};
