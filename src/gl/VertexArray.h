#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "gl/Buffer.h"
#include "gl/Container.h"

namespace aolib::gl {

/// Vertices in GPU memory, ready to draw: positions at location 0, normals and numbers of solids
/// (if any) at locations 1 and 2.
class VertexArray {
public:
    VertexArray() = default;
    /// No vertices at all: for passes that make theirs from gl_VertexID. Errors: OutOfMemory.
    static Result<VertexArray> createEmpty(const Functions& gl, const std::string& label);
    /// What the triangles are made of; `normals` and `solids` may be empty.
    struct Triangles {
        std::span<const glm::vec3> positions;
        std::span<const glm::vec3> normals;
        std::span<const float> solids; ///< per vertex, location 2
        std::span<const std::uint32_t> indices;
    };
    /// Indexed triangles. Errors: OutOfMemory.
    static Result<VertexArray> createTriangles(const Functions& gl, const Triangles& triangles,
                                               const std::string& label);

    /// Draws the indexed triangles.
    void drawTriangles() const;
    /// Draws `count` vertices without attributes as `mode`, numbered from `first` on.
    void drawGenerated(GLenum mode, int count, int first = 0) const;
    /// Covers the viewport with one triangle (fullscreen.vert).
    void drawFullscreen() const { drawGenerated(GL_TRIANGLES, 3); }

    explicit operator bool() const { return static_cast<bool>(name_); }
    bool hasNormals() const { return normals_.bytes() != 0; }
    std::size_t bytes() const {
        return positions_.bytes() + normals_.bytes() + solids_.bytes() + indices_.bytes();
    }

private:
    const Functions* gl_ = nullptr;
    Container name_;
    Buffer positions_;
    Buffer normals_;
    Buffer solids_;
    Buffer indices_;
    GLsizei indexCount_ = 0;
};

} // namespace aolib::gl
