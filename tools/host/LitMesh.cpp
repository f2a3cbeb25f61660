#include "host/LitMesh.h"

#include <algorithm>
#include <span>

namespace aolib::host {

namespace {

template <typename Element>
gl::BufferName upload(const gl::Functions& gl, GLenum target,
                      const std::vector<Element>& elements) {
    auto buffer = gl::generate<gl::BufferName>(gl, &gl::Functions::GenBuffers);
    gl.BindBuffer(target, buffer.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(std::span(elements).size_bytes()),
                  elements.data(), GL_STATIC_DRAW);
    return buffer;
}

template <typename Vector>
gl::BufferName attribute(const gl::Functions& gl, GLuint location,
                         const std::vector<Vector>& values) {
    gl::BufferName buffer = upload(gl, GL_ARRAY_BUFFER, values);
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, Vector::length(), GL_FLOAT, GL_FALSE, sizeof(Vector), nullptr);
    return buffer;
}

} // namespace

Result<LitMesh> LitMesh::create(const gl::Functions& gl, const LitPiece& piece) {
    LitMesh mesh;
    mesh.gl_ = &gl;
    mesh.colour_ = piece.colour;
    mesh.indexCount_ = static_cast<GLsizei>(piece.indices.size());
    mesh.array_ = gl::generate<gl::VertexArrayName>(gl, &gl::Functions::GenVertexArrays);
    gl.BindVertexArray(mesh.array_.name());
    mesh.buffers_.push_back(attribute(gl, 0, piece.positions));
    mesh.buffers_.push_back(attribute(gl, 1, piece.normals));
    mesh.buffers_.push_back(attribute(gl, 2, piece.open));
    mesh.buffers_.push_back(attribute(gl, 3, piece.plain));
    mesh.buffers_.push_back(upload(gl, GL_ELEMENT_ARRAY_BUFFER, piece.indices));
    gl.BindVertexArray(0);
    const bool complete = std::all_of(mesh.buffers_.begin(), mesh.buffers_.end(),
                                      [](const gl::BufferName& name) { return bool(name); });
    if (!mesh.array_ || !complete) {
        return Status(StatusCode::OutOfMemory, "GL gave no names for a lit mesh's buffers");
    }
    return mesh;
}

void LitMesh::draw() const {
    gl_->BindVertexArray(array_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

} // namespace aolib::host
