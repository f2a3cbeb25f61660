#pragma once

#include <string>

#include "gl/StateGuard.h"

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
            count(gl_, 1);
        }
    }
    ~DebugGroup() {
        if (pushed_) {
            gl_.PopDebugGroup();
            count(gl_, -1);
        }
    }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    /// The host may have filled the stack of groups: a push would fail, and the pop be the host's.
    static bool hasRoom(const Functions& gl) {
        return gl.capabilities.debug && gl.debugGroups &&
               (gl.guard != nullptr ? roomUnder(*gl.guard, gl) : roomNow(gl)) > 0;
    }
    /// The host opens and closes none within a call: GL is asked once.
    static int roomUnder(StateGuard& guard, const Functions& gl) {
        guard.debugRoom = guard.debugRoom < 0 ? roomNow(gl) : guard.debugRoom;
        return guard.debugRoom;
    }
    static int roomNow(const Functions& gl) {
        GLint depth = 0;
        gl.GetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &depth);
        return gl.capabilities.maxDebugGroups - depth;
    }
    static void count(const Functions& gl, int more) {
        if (gl.guard != nullptr) {
            gl.guard->debugRoom -= more;
        }
    }

    const Functions& gl_;
    const bool pushed_;
};

} // namespace aolib::gl
