#pragma once

#include <vector>

#include "gl/Functions.h"

namespace aolib::gl {

/// The host's settings of uploads and readbacks: pixel buffers, pixel store, pixel transfer, read
/// clamp. Taken aside when pixels are first moved.
class PixelPaths {
public:
    /// @param trusted  nothing is queried, and restore() does nothing.
    PixelPaths(const Functions& gl, bool trusted) : gl_(gl), trusted_(trusted) {}
    /// Before pixels are moved.
    void use();
    void restore() const;

private:
    struct Store {
        GLenum name;
        GLint value;
    };
    struct Transfer {
        GLenum name;
        GLfloat value;
    };

    void save();
    void set() const;

    const Functions& gl_;
    bool trusted_;
    bool used_ = false;
    GLint packBuffer_ = 0;
    GLint unpackBuffer_ = 0;
    std::vector<Store> store_;
    std::vector<Transfer> transfer_;
    GLint clampReadColor_ = 0;
};

} // namespace aolib::gl
