#include "platform/EglPlatform.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace aolib {
namespace {

template <typename Function>
Function eglFunction(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

std::vector<EGLDeviceEXT> findDevices(const char* clientExtensions) {
    const bool enumerable = listsExtension(clientExtensions, "EGL_EXT_device_enumeration") ||
                            listsExtension(clientExtensions, "EGL_EXT_device_base");
    const auto queryDevices = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    if (!enumerable || queryDevices == nullptr ||
        !listsExtension(clientExtensions, "EGL_EXT_platform_device")) {
        return {};
    }
    EGLint count = 0;
    if (queryDevices(0, nullptr, &count) == EGL_FALSE || count < 1) {
        return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count), EGL_NO_DEVICE_EXT);
    if (queryDevices(count, devices.data(), &count) == EGL_FALSE) {
        return {};
    }
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

bool isSoftware(EGLDeviceEXT device) {
    const auto queryString = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return queryString != nullptr &&
           listsExtension(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

Result<std::vector<EglPlatform>> pickDevice(const std::vector<EglPlatform>& devices,
                                            std::string_view wanted) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (error != std::errc() || end != wanted.data() + wanted.size() || index >= devices.size()) {
        return AoStatus(StatusCode::InvalidOption,
                        "AOLIB_EGL_DEVICE is \"" + std::string(wanted) + "\", but EGL lists " +
                            std::to_string(devices.size()) + " devices, counted from 0.");
    }
    return std::vector<EglPlatform>{devices[index]};
}

} // namespace

bool listsExtension(const char* list, const char* name) {
    if (list == nullptr) {
        return false;
    }
    const auto padded = [](const char* text) { return std::string(" ").append(text).append(" "); };
    return padded(list).find(padded(name)) != std::string::npos;
}

std::string eglErrorName(EGLint error) {
    constexpr std::array<const char*, 15> names{
        "EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
        "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
        "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
        "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
        "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
    const auto index = static_cast<std::size_t>(error - EGL_SUCCESS);
    return error >= EGL_SUCCESS && index < names.size() ? names[index]
                                                        : "EGL error " + std::to_string(error);
}

Result<std::vector<EglPlatform>> findEglPlatforms() {
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<EglPlatform> devices;
    for (EGLDeviceEXT device : findDevices(extensions)) {
        devices.push_back(
            {EGL_PLATFORM_DEVICE_EXT, device, "EGL device " + std::to_string(devices.size())});
    }
    const char* wanted = std::getenv("AOLIB_EGL_DEVICE");
    if (wanted != nullptr && *wanted != '\0') {
        return pickDevice(devices, wanted);
    }
    std::vector<EglPlatform> platforms = std::move(devices);
    std::stable_partition(platforms.begin(), platforms.end(),
                          [](const EglPlatform& platform) { return !isSoftware(platform.device); });
    if (listsExtension(extensions, "EGL_MESA_platform_surfaceless")) {
        platforms.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_NO_DEVICE_EXT, "EGL surfaceless"});
    }
    platforms.push_back({EGL_NONE, EGL_NO_DEVICE_EXT, "EGL default display"});
    return platforms;
}

} // namespace aolib
