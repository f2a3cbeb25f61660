#pragma once

#include <string_view>
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "Boxes.h"

/// The triangles, cut until no edge is longer than said: light of vertices needs vertices.
Triangles cutFine(const Triangles& coarse, float longest);

/// The host's own renderer: a mesh whose vertices have a bent normal and a visibility, and a shader
/// that is lit by functions it is given. It knows nothing of aolib.
class LitHost {
public:
    /// @param open       bent normal and visibility of each vertex.
    /// @param functions  text in GLSL that has aoConeLight().
    /// Throws std::runtime_error with the driver's log when the shader does not build.
    LitHost(const Triangles& scene, const std::vector<glm::vec4>& open, std::string_view functions);

    /// Draws a frame. @param cones  the texture array that aoConeLight() reads.
    void draw(const glm::mat4& worldToClip, GLuint cones) const;
    /// What was drawn, RGB, the bottom row first.
    static std::vector<std::uint8_t> read();

private:
    GLuint program_ = 0;
    GLuint vertices_ = 0;
    GLsizei indexCount_ = 0;
};
