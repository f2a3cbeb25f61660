#pragma once

#include <functional>

namespace aolib {

/// Returns the address of an OpenGL function of the current context by name ("glDrawElements"), or
/// null. The host supplies the loader: SDL, GLFW, EGL, GLX and OSMesa each have such a function.
/// aolib calls the loader only while it fills its function table.
///
/// Some drivers return an address for any name that starts with "gl". Therefore aolib also checks
/// the version and the extensions of the context.
/// The addresses 1, 2, 3 and -1 count as null, because wglGetProcAddress also returns these.
///
/// WGL: wglGetProcAddress returns null for functions of OpenGL 1.1 (glGetString, glDrawElements
/// ...); opengl32.dll exports these. A loader for WGL calls both:
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
/// The loaders of GLFW and SDL already call both:
///
/// ```cpp
/// ProcAddressLoader loader = [](const char* name) -> void* {
///     return reinterpret_cast<void*>(glfwGetProcAddress(name));
/// };
/// ```
/// Context: the context that the functions belong to must be current in the calling thread.
/// Since 0.1.
using ProcAddressLoader = std::function<void*(const char* name)>;

} // namespace aolib
