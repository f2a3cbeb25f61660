#pragma once

#include <memory>
#include <string>

/// What this host draws to: a window of GLFW, or nothing that anyone sees. Its OpenGL 3.3 core
/// context is current from open() to the end; framebuffer 0 has colour and depth.
class Display {
public:
    using GetProcAddress = void* (*)(const char* name);

    /// @param width,height  pixels.
    /// @return null when there is no display or no context; then `reason` says why.
    static std::unique_ptr<Display> openWindow(int width, int height, std::string& reason);
    static std::unique_ptr<Display> openOffscreen(int width, int height, std::string& reason);
    virtual ~Display() = default;

    /// The address of an OpenGL function: glfwGetProcAddress, eglGetProcAddress ...
    virtual GetProcAddress getProcAddress() const = 0;
    /// Whether nobody has closed it.
    virtual bool open() const = 0;
    /// Shows what was drawn.
    virtual void show() = 0;
};
