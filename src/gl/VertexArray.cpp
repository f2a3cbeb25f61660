#include "gl/VertexArray.h"

#include "gl/Label.h"

namespace aolib::gl {

Result<VertexArray> VertexArray::createEmpty(const Functions& gl, const std::string& label) {
    VertexArray array;
    array.gl_ = &gl;
    array.name_ = generate<VertexArrayName>(gl, &Functions::GenVertexArrays);
    if (!array.name_) {
        return Status(StatusCode::OutOfMemory, label + ": GL gave no vertex array name");
    }
    gl.BindVertexArray(array.name_.name());
    gl::label(gl, GL_VERTEX_ARRAY, array.name_.name(), label);
    return array;
}

Result<VertexArray> VertexArray::createTriangles(const Functions& gl,
                                                 std::span<const glm::vec3> positions,
                                                 std::span<const glm::vec3> normals,
                                                 std::span<const std::uint32_t> indices,
                                                 const std::string& label) {
    Result<VertexArray> created = createEmpty(gl, label);
    if (!created) {
        return created;
    }
    VertexArray& array = *created;
    const auto fill = [&](Buffer& buffer, GLenum target, std::size_t bytes, const void* data,
                          const char* part) -> Status {
        Result<Buffer> filled =
            Buffer::create(gl, target, bytes, data, GL_STATIC_DRAW, label + part);
        if (filled) {
            buffer = std::move(*filled);
        }
        return filled.status();
    };
    const auto attribute = [&](GLuint location) {
        gl.EnableVertexAttribArray(location);
        gl.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
    };
    if (Status status = fill(array.positions_, GL_ARRAY_BUFFER, positions.size_bytes(),
                             positions.data(), "/positions");
        !status) {
        return status;
    }
    attribute(0);
    if (!normals.empty()) {
        if (Status status = fill(array.normals_, GL_ARRAY_BUFFER, normals.size_bytes(),
                                 normals.data(), "/normals");
            !status) {
            return status;
        }
        attribute(1);
    }
    if (Status status = fill(array.indices_, GL_ELEMENT_ARRAY_BUFFER, indices.size_bytes(),
                             indices.data(), "/indices");
        !status) {
        return status;
    }
    array.indexCount_ = static_cast<GLsizei>(indices.size());
    return created;
}

void VertexArray::drawTriangles() const {
    gl_->BindVertexArray(name_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void VertexArray::drawGenerated(GLenum mode, int count) const {
    gl_->BindVertexArray(name_.name());
    gl_->DrawArrays(mode, 0, count);
}

} // namespace aolib::gl
