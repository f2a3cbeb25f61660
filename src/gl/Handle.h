#pragma once

#include <type_traits>
#include <utility>

#include "gl/ContextGroup.h"

namespace aolib::gl {

/// A GL object name that is deleted with its owner, in a context that may delete it (see
/// ContextGroup). Move-only; 0 is "none".
/// `Delete` names the member of Functions that deletes an array of such names.
template <auto Delete>
class Handle {
public:
    Handle() = default;
    /// Adopts `name`.
    Handle(const Functions& gl, GLuint name)
        : gl_(&gl), name_(name), owner_(kShared ? 0 : currentContext(gl)) {}
    Handle(Handle&& other) noexcept
        : gl_(std::exchange(other.gl_, nullptr)), name_(std::exchange(other.name_, 0U)),
          owner_(other.owner_) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        std::swap(owner_, other.owner_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) {
            release(*gl_, owner_,
                    [deleteNames = gl_->*Delete, name = name_] { deleteNames(1, &name); });
        }
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    /// Whether all contexts of a group see such objects.
    static constexpr bool kShared = [] {
        if constexpr (std::is_same_v<decltype(Delete), PFNGLDELETEFRAMEBUFFERSPROC Functions::*>) {
            return Delete != &Functions::DeleteFramebuffers &&
                   Delete != &Functions::DeleteVertexArrays && Delete != &Functions::DeleteQueries;
        }
        return true;
    }();

    const Functions* gl_ = nullptr;
    GLuint name_ = 0;
    ContextId owner_ = 0; ///< the context that has it; 0 where all of a group share it
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
