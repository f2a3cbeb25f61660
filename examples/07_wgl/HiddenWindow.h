#pragma once

#include <memory>
#include <string>

/// A window that nobody sees, with an OpenGL 3.3 core context of WGL's that is current for as long
/// as the window lives. Framebuffer 0 has colour and 24 bits of depth.
class HiddenWindow {
public:
    /// @param width,height  pixels.
    /// @return null when there is no window or no such context; then `reason` says why.
    static std::unique_ptr<HiddenWindow> open(int width, int height, std::string& reason);
    HiddenWindow(const HiddenWindow&) = delete;
    HiddenWindow& operator=(const HiddenWindow&) = delete;
    ~HiddenWindow();

    /// The address of an OpenGL function of the current context, null if there is none:
    /// wglGetProcAddress for all but OpenGL 1.1, and opengl32.dll for that.
    static void* getProcAddress(const char* name);

private:
    HiddenWindow() = default;
    bool openWindow(int width, int height);
    bool openContext();

    void* window_ = nullptr;  ///< HWND
    void* device_ = nullptr;  ///< HDC
    void* context_ = nullptr; ///< HGLRC
};
