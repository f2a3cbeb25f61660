#include "host/HostMesh.h"

#include <span>

namespace aolib::host {

namespace {

constexpr GLuint kPositionLocation = 0;
constexpr GLuint kNormalLocation = 1;

template <typename Element>
gl::BufferName upload(const gl::Functions& gl, GLenum target, std::span<const Element> elements) {
    auto buffer = gl::generate<gl::BufferName>(gl, &gl::Functions::GenBuffers);
    gl.BindBuffer(target, buffer.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(elements.size_bytes()), elements.data(),
                  GL_STATIC_DRAW);
    return buffer;
}

void pointTo(const gl::Functions& gl, GLuint location) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
}

} // namespace

Result<HostMesh> HostMesh::create(const gl::Functions& gl, const ModelMesh& mesh) {
    HostMesh uploaded;
    uploaded.gl_ = &gl;
    uploaded.transform_ = mesh.transform;
    uploaded.colour_ = glm::vec3(mesh.baseColour);
    uploaded.indexCount_ = static_cast<GLsizei>(mesh.indices.size());
    uploaded.array_ = gl::generate<gl::VertexArrayName>(gl, &gl::Functions::GenVertexArrays);
    gl.BindVertexArray(uploaded.array_.name());
    uploaded.positions_ = upload(gl, GL_ARRAY_BUFFER, std::span(mesh.positions));
    pointTo(gl, kPositionLocation);
    if (!mesh.normals.empty()) {
        uploaded.normals_ = upload(gl, GL_ARRAY_BUFFER, std::span(mesh.normals));
        pointTo(gl, kNormalLocation);
    }
    uploaded.indices_ = upload(gl, GL_ELEMENT_ARRAY_BUFFER, std::span(mesh.indices));
    gl.BindVertexArray(0);
    if (!uploaded.array_ || !uploaded.positions_ || !uploaded.indices_) {
        return AoStatus(StatusCode::OutOfMemory, mesh.name + ": GL gave no names for its buffers");
    }
    return uploaded;
}

void HostMesh::draw() const {
    gl_->BindVertexArray(array_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

} // namespace aolib::host
