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
    DebugGroup(const Functions& gl, const char* name) : gl_(gl), pushed_(hasRoom(gl)) {
        if (pushed_) {
            gl_.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
        }
    }
    ~DebugGroup() {
        if (pushed_) {
            gl_.PopDebugGroup();
        }
    }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    /// The host may have filled the stack of groups: a push would fail, and the pop be the host's.
    static bool hasRoom(const Functions& gl) {
        GLint depth = 0;
        GLint limit = 0;
        if (gl.capabilities.debug) {
            gl.GetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
            gl.GetIntegerv(GL_MAX_DEBUG_GROUP_STACK_DEPTH, &limit);
        }
        return depth < limit;
    }

    const Functions& gl_;
    const bool pushed_;
};

} // namespace aolib::gl
