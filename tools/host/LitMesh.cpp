#include "host/LitMesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// Bytes, four a location.
gl::BufferName sectorAttributes(const gl::Functions& gl, const LitPiece& piece) {
    using Bytes = std::array<std::uint8_t, 24>;
    std::vector<Bytes> bytes;
    bytes.reserve(piece.sectors.size());
    for (const std::array<float, 24>& open : piece.sectors) {
        Bytes& own = bytes.emplace_back();
        std::transform(open.begin(), open.end(), own.begin(), [](float share) {
            return static_cast<std::uint8_t>(255.0F * std::clamp(share, 0.0F, 1.0F) + 0.5F);
        });
    }
    gl::BufferName buffer = upload(gl, GL_ARRAY_BUFFER, bytes);
    for (GLuint i = 0; i < 6 && !bytes.empty(); ++i) {
        gl.EnableVertexAttribArray(4 + i);
        gl.VertexAttribPointer(4 + i, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Bytes),
                               reinterpret_cast<const void*>(std::size_t{i} * 4));
    }
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
    mesh.buffers_.push_back(sectorAttributes(gl, piece));
    mesh.buffers_.push_back(upload(gl, GL_ELEMENT_ARRAY_BUFFER, piece.indices));
    gl.BindVertexArray(0);
    const bool complete = std::all_of(mesh.buffers_.begin(), mesh.buffers_.end(),
                                      [](const gl::BufferName& name) { return bool(name); });
    if (!mesh.array_ || !complete) {
        return AoStatus(StatusCode::OutOfMemory, "GL gave no names for a lit mesh's buffers");
    }
    return mesh;
}

void LitMesh::draw() const {
    gl_->BindVertexArray(array_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

} // namespace aolib::host
