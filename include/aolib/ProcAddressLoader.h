#pragma once

#include <functional>

namespace aolib {

/// Gives the address of an OpenGL function of the context that is current, by its name
/// ("glDrawElements"), or null when there is none. The host supplies it: SDL, GLFW, EGL, GLX, WGL
/// and OSMesa each have such a function. aolib calls it only while it reads its function table.
///
/// Some drivers return an address for any name that starts with "gl". A non-null answer is
/// therefore no proof that the context has the function: aolib also asks for version and
/// extensions.
///
/// ```cpp
/// ProcAddressLoader loader = [](const char* name) -> void* {
///     return reinterpret_cast<void*>(glfwGetProcAddress(name));
/// };
/// ```
/// Context: the one that the functions are meant for must be current in the calling thread.
/// Since 0.1.
using ProcAddressLoader = std::function<void*(const char* name)>;

} // namespace aolib
