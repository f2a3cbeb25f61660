#include "gl/VertexArray.h"

#include "gl/Label.h"

namespace aolib::gl {

Result<VertexArray> VertexArray::createEmpty(const Functions& gl, const std::string& label) {
    VertexArray array;
    array.gl_ = &gl;
    array.name_ = generate<VertexArrayName>(gl, &Functions::GenVertexArrays);
    if (!array.name_) {
        return AoStatus(StatusCode::OutOfMemory, label + ": GL gave no vertex array name");
    }
    gl.BindVertexArray(array.name_.name());
    gl::label(gl, GL_VERTEX_ARRAY, array.name_.name(), label);
    return array;
}

Result<VertexArray> VertexArray::createTriangles(const Functions& gl, const Triangles& triangles,
                                                 const std::string& label) {
    Result<VertexArray> created = createEmpty(gl, label);
    if (!created) {
        return created;
    }
    VertexArray& array = *created;
    AoStatus status;
    const auto fill = [&](Buffer& buffer, GLenum target, auto content, const char* part) {
        if (!status || content.empty()) {
            return;
        }
        Result<Buffer> filled = Buffer::create(gl, target, content.size_bytes(), content.data(),
                                               GL_STATIC_DRAW, label + part);
        status = filled.status();
        if (filled) {
            buffer = std::move(*filled);
        }
    };
    const auto attribute = [&](GLuint location, const Buffer& buffer, GLint components) {
        if (status && buffer.bytes() != 0) {
            gl.EnableVertexAttribArray(location);
            gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
        }
    };
    fill(array.positions_, GL_ARRAY_BUFFER, triangles.positions, "/positions");
    attribute(0, array.positions_, 3);
    fill(array.normals_, GL_ARRAY_BUFFER, triangles.normals, "/normals");
    attribute(1, array.normals_, 3);
    fill(array.solids_, GL_ARRAY_BUFFER, triangles.solids, "/solids");
    attribute(2, array.solids_, 1);
    fill(array.indices_, GL_ELEMENT_ARRAY_BUFFER, triangles.indices, "/indices");
    if (!status) {
        return status;
    }
    array.indexCount_ = static_cast<GLsizei>(triangles.indices.size());
    return created;
}

void VertexArray::drawTriangles() const {
    gl_->BindVertexArray(name_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void VertexArray::drawGenerated(GLenum mode, int count, int first) const {
    gl_->BindVertexArray(name_.name());
    gl_->DrawArrays(mode, first, count);
}

} // namespace aolib::gl
