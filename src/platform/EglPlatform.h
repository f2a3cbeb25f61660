#pragma once

#include <aolib/Status.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <string>
#include <vector>

namespace aolib {

/// One place where EGL may have a display: a device, a platform without surfaces, the default.
struct EglPlatform {
    EGLenum platform = EGL_NONE;             ///< EGL_NONE: eglGetDisplay(EGL_DEFAULT_DISPLAY)
    EGLDeviceEXT device = EGL_NO_DEVICE_EXT; ///< of EGL_PLATFORM_DEVICE_EXT
    std::string name;                        ///< "EGL device 0", "EGL surfaceless"
};

/// The places to try on this machine, best first: hardware devices, software devices, Mesa's
/// surfaceless platform, the default display. AOLIB_EGL_DEVICE leaves only the device of that
/// index. Errors: InvalidOption (AOLIB_EGL_DEVICE is no index of a device).
Result<std::vector<EglPlatform>> findEglPlatforms();

/// Whether a list of names separated by spaces holds one. A null list holds none.
bool listsExtension(const char* list, const char* name);

/// "EGL_BAD_MATCH" for 0x3009, and so on; a number for what EGL 1.5 does not know.
std::string eglErrorName(EGLint error);

} // namespace aolib
