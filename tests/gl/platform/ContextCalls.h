#pragma once

#include "platform/GlContext.h"

#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ostream>
#include <string>

/// What the tests of contexts share: names for messages, and the few GL calls that they make.
namespace aolib {

// GoogleTest finds these by argument, so they are in the namespace of the types.
inline void PrintTo(ContextRequest::Api api, std::ostream* out) {
    *out << apiName(api);
}
inline void PrintTo(ContextRequest::Profile profile, std::ostream* out) {
    *out << (profile == ContextRequest::Profile::Core ? "core" : "compatibility");
}

/// Why contexts of this API cannot be expected here; empty if they can.
inline std::string reasonToSkip(ContextRequest::Api api) {
    const auto apis = availableApis();
    if (std::find(apis.begin(), apis.end(), api) == apis.end()) {
        return std::string("NOT TESTED: this build is without ") + apiName(api);
    }
    if (api == ContextRequest::Api::Glfw && std::getenv("DISPLAY") == nullptr &&
        std::getenv("WAYLAND_DISPLAY") == nullptr) {
        return "NOT TESTED: GLFW needs a display server, and neither DISPLAY nor WAYLAND_DISPLAY "
               "is set";
    }
    return {};
}

template <typename Function>
Function lookUp(const GlContext& context, const char* name) {
    const auto function = reinterpret_cast<Function>(context.getProcAddress(name));
    EXPECT_NE(function, nullptr) << name;
    return function;
}

/// Draws one colour over the default framebuffer and reads a pixel of it back.
inline std::array<GLubyte, 4> clearAndRead(const GlContext& context, float red, float green) {
    lookUp<PFNGLCLEARCOLORPROC>(context, "glClearColor")(red, green, 0.0f, 1.0f);
    lookUp<PFNGLCLEARPROC>(context, "glClear")(GL_COLOR_BUFFER_BIT);
    std::array<GLubyte, 4> pixel{};
    lookUp<PFNGLREADPIXELSPROC>(context, "glReadPixels")(3, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                                                         pixel.data());
    return pixel;
}

inline float clearRed(const GlContext& context) {
    std::array<GLfloat, 4> colour{};
    lookUp<PFNGLGETFLOATVPROC>(context, "glGetFloatv")(GL_COLOR_CLEAR_VALUE, colour.data());
    return colour[0];
}

} // namespace aolib
