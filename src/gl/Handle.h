#pragma once

#include <utility>

#include "gl/Functions.h"

namespace aolib::gl {

/// A GL object name that is deleted with its owner. Move-only; 0 is "none".
/// `Delete` names the member of Functions that deletes an array of such names.
template <auto Delete>
class Handle {
public:
    Handle() = default;
    /// Adopts `name`.
    Handle(const Functions& gl, GLuint name) : gl_(&gl), name_(name) {}
    Handle(Handle&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0U)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) {
            (gl_->*Delete)(1, &name_);
        }
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    const Functions* gl_ = nullptr;
    GLuint name_ = 0;
};

using Texture = Handle<&Functions::DeleteTextures>;
using Framebuffer = Handle<&Functions::DeleteFramebuffers>;
using BufferName = Handle<&Functions::DeleteBuffers>;
using VertexArrayName = Handle<&Functions::DeleteVertexArrays>;
using Query = Handle<&Functions::DeleteQueries>;

/// A fresh name from a glGen* function.
template <typename HandleType, typename Generate>
HandleType generate(const Functions& gl, Generate Functions::*function) {
    GLuint name = 0;
    (gl.*function)(1, &name);
    return HandleType(gl, name);
}

} // namespace aolib::gl
