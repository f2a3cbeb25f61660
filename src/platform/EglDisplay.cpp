#include "platform/EglDisplay.h"

namespace aolib {
namespace {

EGLDisplay getDisplay(const EglPlatform& platform) {
    if (platform.platform == EGL_NONE) {
        return eglGetDisplay(EGL_DEFAULT_DISPLAY);
    }
    const auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return getPlatformDisplay == nullptr
               ? EGL_NO_DISPLAY
               : getPlatformDisplay(platform.platform, platform.device, nullptr);
}

} // namespace

Result<EglDisplay> EglDisplay::open(const EglPlatform& platform) {
    EglDisplay display;
    display.name_ = platform.name;
    display.handle_ = getDisplay(platform);
    if (display.handle_ == EGL_NO_DISPLAY) {
        return AoStatus(StatusCode::NoContext, platform.name + ": there is no such display (" +
                                                   eglErrorName(eglGetError()) + ").");
    }
    if (eglInitialize(display.handle_, &display.major_, &display.minor_) == EGL_FALSE) {
        return AoStatus(StatusCode::NoContext, platform.name + ": eglInitialize failed (" +
                                                   eglErrorName(eglGetError()) + ").");
    }
    return display;
}

bool EglDisplay::atLeast(EGLint major, EGLint minor) const {
    return major_ > major || (major_ == major && minor_ >= minor);
}

bool EglDisplay::has(const char* extension) const {
    return listsExtension(eglQueryString(handle_, EGL_EXTENSIONS), extension);
}

} // namespace aolib
