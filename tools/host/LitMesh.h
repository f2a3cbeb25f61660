#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>

#include "gl/Handle.h"

namespace aolib::host {

/// A piece of a scene with what was baked of its vertices; vectors as long as `positions`.
struct LitPiece {
    std::vector<glm::vec3> positions;           ///< world units
    std::vector<glm::vec3> normals;             ///< unit
    std::vector<glm::vec4> open;                ///< bent normal by the cosine, visibility W
    std::vector<glm::vec4> plain;               ///< mean open direction, share of open directions
    std::vector<std::array<float, 24>> sectors; ///< how open each sector of directions is
    std::vector<std::uint32_t> indices;
    glm::vec3 colour{1.0F}; ///< linear
};

/// Such a piece in GPU memory: locations 0 to 3 in the order above, sectors from 4.
class LitMesh {
public:
    /// @param gl  must outlive the mesh. Errors: OutOfMemory.
    static Result<LitMesh> create(const gl::Functions& gl, const LitPiece& piece);

    /// Draws its triangles with the program that is in use.
    void draw() const;

    const glm::vec3& colour() const { return colour_; }

private:
    const gl::Functions* gl_ = nullptr;
    gl::VertexArrayName array_;
    std::vector<gl::BufferName> buffers_;
    GLsizei indexCount_ = 0;
    glm::vec3 colour_{1.0F};
};

} // namespace aolib::host
