#pragma once

#include <optional>

#include <aolib/Status.h>
#include <glm/vec2.hpp>

#include "host/HostFramebuffer.h"
#include "image/Image.h"

namespace aolib::viewer {

/// Two pictures of one size, of which the window shows the left part of one and the right part of
/// the other. Context: the one current at create(), for every call.
class SplitPicture {
public:
    /// @param gl  must outlive it.
    explicit SplitPicture(const gl::Functions& gl) : gl_(&gl) {}

    /// Makes room; keeps what is there if the size is the same. Errors: as HostFramebuffer's.
    AoStatus resize(const glm::ivec2& pixels);
    const glm::ivec2& size() const { return size_; }

    const host::HostFramebuffer& left() const { return *left_; }
    /// Made when it is first asked for.
    Result<const host::HostFramebuffer*> right();

    /// Copies both to the window's framebuffer, from its lower left corner, and leaves that bound.
    /// @param column  the first that the right picture has; the width if there is none.
    void present(int column) const;
    /// The window's picture, RGB, before it is shown.
    static ByteImage readWindow(const gl::Functions& gl, const glm::ivec2& pixels);

private:
    const gl::Functions* gl_;
    glm::ivec2 size_{0};
    std::optional<host::HostFramebuffer> left_;
    std::optional<host::HostFramebuffer> right_;
};

} // namespace aolib::viewer
