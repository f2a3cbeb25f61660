#pragma once

#include "platform/EglPlatform.h"

#include <string>

namespace aolib {

/// An initialised EGL display. EGL has one display per platform and device in a process; opening
/// it again gives the same one. It stays initialised until the process ends: eglTerminate() would
/// end it for every other context on it, and Mesa then unloads its driver, which leaks and doubles
/// the time to the next context. Thread: any.
class EglDisplay {
public:
    /// The display of that platform. Errors: NoContext, with EGL's reason.
    static Result<EglDisplay> open(const EglPlatform& platform);

    EGLDisplay handle() const { return handle_; }
    const std::string& name() const { return name_; }
    bool atLeast(EGLint major, EGLint minor) const;
    bool has(const char* extension) const;

private:
    EglDisplay() = default;

    EGLDisplay handle_ = EGL_NO_DISPLAY;
    EGLint major_ = 0;
    EGLint minor_ = 0;
    std::string name_;
};

} // namespace aolib
