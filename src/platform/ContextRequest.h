#pragma once

#include <string>

namespace aolib {

/// What kind of OpenGL context a tool or a test wants. Since 0.1.
struct ContextRequest {
    enum class Api {
        Egl,    ///< no window; the graphics card if there is one, else a software rasteriser
        OsMesa, ///< no window; Mesa's software rasteriser, drawing into client memory
        Glfw,   ///< a window; needs a display server
    };
    enum class Profile { Core, Compatibility };

    Api api = Api::Egl;
    Profile profile = Profile::Core; ///< has a meaning from OpenGL 3.2 on
    int major = 3;                   ///< least version wanted; drivers may give a newer one
    int minor = 3;
    bool debug = false;              ///< a debug context; OSMesa has none and ignores it
    bool defaultFramebuffer = false; ///< EGL only: OSMesa and GLFW always have one
    int width = 16;                  ///< of the default framebuffer, pixels, at least 1
    int height = 16;                 ///< of the default framebuffer, pixels, at least 1
    int samples = 0;                 ///< of the default framebuffer, 0 for none; not with OSMesa
    bool visible = false;            ///< GLFW only: show the window
    std::string title = "aolib";     ///< GLFW only: of the window
};

/// "EGL", "OSMesa" or "GLFW".
const char* apiName(ContextRequest::Api api);

/// What was asked for, for messages: "OpenGL 3.3 core context".
std::string wantedContext(const ContextRequest& request);

} // namespace aolib
