#include "gl/VertexArray.h"

#include <array>

#include "gl/Label.h"

namespace aolib::gl {

Result<VertexArray> VertexArray::createEmpty(const Functions& gl, const std::string& label) {
    VertexArray array;
    array.gl_ = &gl;
    const auto fill = [label](const Functions& in, GLuint name) -> AoStatus {
        in.BindVertexArray(name);
        gl::label(in, GL_VERTEX_ARRAY, name, label);
        return {};
    };
    auto name = Container::create(gl, Container::kVertexArray, label, fill);
    if (!name) {
        return name.status();
    }
    array.name_ = std::move(*name);
    return array;
}

Result<VertexArray> VertexArray::createTriangles(const Functions& gl, const Triangles& triangles,
                                                 const std::string& label) {
    VertexArray array;
    array.gl_ = &gl;
    AoStatus status;
    // All are vertices here: the binding of indices belongs to the vertex array that is current.
    const auto fill = [&](Buffer& buffer, auto content, const char* part) {
        if (!status || content.empty()) {
            return;
        }
        Result<Buffer> filled = Buffer::create(gl, GL_ARRAY_BUFFER, content.size_bytes(),
                                               content.data(), GL_STATIC_DRAW, label + part);
        status = filled.status();
        if (filled) {
            buffer = std::move(*filled);
        }
    };
    fill(array.positions_, triangles.positions, "/positions");
    fill(array.normals_, triangles.normals, "/normals");
    fill(array.solids_, triangles.solids, "/solids");
    fill(array.indices_, triangles.indices, "/indices");
    if (!status) {
        return status;
    }
    struct Attribute {
        GLuint buffer;
        GLint components;
    };
    const std::array<Attribute, 3> attributes{Attribute{array.positions_.name(), 3},
                                              Attribute{array.normals_.name(), 3},
                                              Attribute{array.solids_.name(), 1}};
    const auto specify = [attributes, indices = array.indices_.name(),
                          label](const Functions& in, GLuint name) -> AoStatus {
        in.BindVertexArray(name);
        gl::label(in, GL_VERTEX_ARRAY, name, label);
        for (GLuint location = 0; location < attributes.size(); ++location) {
            const Attribute& attribute = attributes[location];
            if (attribute.buffer != 0) {
                in.BindBuffer(GL_ARRAY_BUFFER, attribute.buffer);
                in.EnableVertexAttribArray(location);
                in.VertexAttribPointer(location, attribute.components, GL_FLOAT, GL_FALSE, 0,
                                       nullptr);
            }
        }
        in.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
        return {};
    };
    auto name = Container::create(gl, Container::kVertexArray, label, specify);
    if (!name) {
        return name.status();
    }
    array.name_ = std::move(*name);
    array.indexCount_ = static_cast<GLsizei>(triangles.indices.size());
    return array;
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
