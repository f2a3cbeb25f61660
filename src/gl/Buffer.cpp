#include "gl/Buffer.h"

#include "gl/Label.h"

namespace aolib::gl {

Result<Buffer> Buffer::create(const Functions& gl, GLenum target, std::size_t bytes,
                              const void* data, GLenum usage, const std::string& label) {
    Buffer buffer;
    buffer.name_ = generate<BufferName>(gl, &Functions::GenBuffers);
    buffer.bytes_ = bytes;
    if (!buffer.name_) {
        return AoStatus(StatusCode::OutOfMemory, label + ": GL gave no buffer name");
    }
    gl.BindBuffer(target, buffer.name());
    gl::label(gl, GL_BUFFER, buffer.name(), label);
    gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
    GLint size = 0; // read as an int: all that is asked is whether there is any
    gl.GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
    if (size == 0 && bytes > 0) {
        return AoStatus(StatusCode::OutOfMemory,
                        label + ": no memory for " + std::to_string(bytes) + " bytes");
    }
    return buffer;
}

} // namespace aolib::gl
