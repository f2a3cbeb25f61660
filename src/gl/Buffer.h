#pragma once

#include <cstddef>
#include <string>

#include <aolib/Status.h>

#include "gl/Handle.h"

namespace aolib::gl {

/// A buffer object with content that is given once.
class Buffer {
public:
    Buffer() = default;
    /// @param target  GL_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER, ...: the binding used to fill it.
    /// @param data    `bytes` bytes, or null to leave them undefined. Errors: OutOfMemory.
    static Result<Buffer> create(const Functions& gl, GLenum target, std::size_t bytes,
                                 const void* data, GLenum usage, const std::string& label);

    GLuint name() const { return name_.name(); }
    std::size_t bytes() const { return bytes_; }

private:
    BufferName name_;
    std::size_t bytes_ = 0;
};

} // namespace aolib::gl
