#pragma once

#include <string>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <aolib/Status.h>

#include "content/Model.h"
#include "gl/Handle.h"

namespace aolib::host {

/// One mesh of a model in GPU memory: positions at location 0, normals (if any) at location 1.
class HostMesh {
public:
    /// Uploads it. @param gl  must outlive the mesh. Errors: OutOfMemory.
    static Result<HostMesh> create(const gl::Functions& gl, const ModelMesh& mesh);

    /// Draws its triangles with the program that is in use.
    void draw() const;

    bool hasNormals() const { return static_cast<bool>(normals_); }
    const glm::mat4& transform() const { return transform_; } ///< model to world
    const glm::vec3& colour() const { return colour_; }       ///< linear RGB

private:
    const gl::Functions* gl_ = nullptr;
    gl::VertexArrayName array_;
    gl::BufferName positions_;
    gl::BufferName normals_;
    gl::BufferName indices_;
    GLsizei indexCount_ = 0;
    glm::mat4 transform_{1.0F};
    glm::vec3 colour_{1.0F};
};

} // namespace aolib::host
