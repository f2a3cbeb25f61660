#include "gl/Buffer.h"

#include "gl/Label.h"

namespace aolib::gl {

Result<Buffer> Buffer::create(const Functions& gl, GLenum target, std::size_t bytes,
                              const void* data, GLenum usage, const std::string& label) {
    Buffer buffer;
    buffer.name_ = generate<BufferName>(gl, &Functions::GenBuffers);
    buffer.bytes_ = bytes;
    if (!buffer.name_) {
        return Status(StatusCode::OutOfMemory, label + ": GL gave no buffer name");
    }
    gl.BindBuffer(target, buffer.name());
    gl::label(gl, GL_BUFFER, buffer.name(), label);
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    return buffer;
}

} // namespace aolib::gl
