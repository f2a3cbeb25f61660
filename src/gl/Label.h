#pragma once

#include <string>

#include "gl/Functions.h"

namespace aolib::gl {

/// Names an object for debuggers ("aolib/cube3/visibility"), where the context knows KHR_debug.
inline void label(const Functions& gl, GLenum kind, GLuint name, const std::string& text) {
    if (gl.capabilities.debug && name != 0) {
        gl.ObjectLabel(kind, name, static_cast<GLsizei>(text.size()), text.c_str());
    }
}

/// Groups the commands of its scope under a name for debuggers.
class DebugGroup {
public:
    DebugGroup(const Functions& gl, const char* name) : gl_(gl) {
        if (gl_.capabilities.debug) {
            gl_.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
        }
    }
    ~DebugGroup() {
        if (gl_.capabilities.debug) {
            gl_.PopDebugGroup();
        }
    }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    const Functions& gl_;
};

} // namespace aolib::gl
