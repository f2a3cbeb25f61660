#pragma once

#include <functional>

namespace aolib {

/// Gives the address of an OpenGL function of the context that is current, by its name
/// ("glDrawElements"), or null when there is none. The host supplies it: SDL, GLFW, EGL, GLX and
/// OSMesa each have such a function. aolib calls it only while it reads its function table.
///
/// Some drivers return an address for any name that starts with "gl". A non-null answer is
/// therefore no proof that the context has the function: aolib also asks for version and
/// extensions.
/// The addresses 1, 2, 3 and -1 count as null, for wglGetProcAddress returns them, too.
///
/// WGL: wglGetProcAddress knows no function of OpenGL 1.1 (glGetString, glDrawElements ...); those
/// are exported by opengl32.dll. A loader asks both:
///
/// ```cpp
/// ProcAddressLoader loader = [](const char* name) -> void* {
///     auto* address = reinterpret_cast<void*>(wglGetProcAddress(name));
///     const auto value = reinterpret_cast<std::intptr_t>(address);
///     const bool absent = value >= -1 && value <= 3; // drivers answer 0, 1, 2, 3 or -1
///     return absent ? reinterpret_cast<void*>(
///                         GetProcAddress(GetModuleHandleA("opengl32.dll"), name))
///                   : address;
/// };
/// ```
/// GLFW and SDL do that themselves:
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
