#include "HiddenWindow.h"

#include <cstdint>
#include <cstring>

#include <windows.h>

namespace {

// Of WGL_ARB_create_context and WGL_ARB_create_context_profile.
constexpr int kContextMajorVersion = 0x2091;
constexpr int kContextMinorVersion = 0x2092;
constexpr int kContextProfileMask = 0x9126;
constexpr int kContextCoreProfile = 1;
using CreateContextAttribs = HGLRC(WINAPI*)(HDC device, HGLRC shared, const int* attributes);

} // namespace

std::unique_ptr<HiddenWindow> HiddenWindow::open(int width, int height, std::string& reason) {
    std::unique_ptr<HiddenWindow> window(new HiddenWindow);
    if (!window->openWindow(width, height)) {
        reason = "no window with OpenGL: error " + std::to_string(GetLastError()) + " of Windows";
        return nullptr;
    }
    if (!window->openContext()) {
        reason =
            "no OpenGL 3.3 core context: error " + std::to_string(GetLastError()) + " of Windows";
        return nullptr;
    }
    return window;
}

bool HiddenWindow::openWindow(int width, int height) {
    WNDCLASSA kind{};
    kind.style = CS_OWNDC;
    kind.lpfnWndProc = DefWindowProcA;
    kind.hInstance = GetModuleHandleA(nullptr);
    kind.lpszClassName = "aolib example";
    RegisterClassA(&kind);
    // A popup has no frame: its size is that of framebuffer 0.
    const HWND window = CreateWindowA(kind.lpszClassName, "aolib: WGL", WS_POPUP, 0, 0, width,
                                      height, nullptr, nullptr, kind.hInstance, nullptr);
    window_ = window;
    if (window == nullptr) {
        return false;
    }
    const HDC device = GetDC(window);
    device_ = device;
    PIXELFORMATDESCRIPTOR format{};
    format.nSize = sizeof(format);
    format.nVersion = 1;
    format.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    format.iPixelType = PFD_TYPE_RGBA;
    format.cColorBits = 24;
    format.cDepthBits = 24;
    const int chosen = ChoosePixelFormat(device, &format);
    return chosen != 0 && SetPixelFormat(device, chosen, &format) != FALSE;
}

bool HiddenWindow::openContext() {
    // WGL gives the function that makes a core context to those alone who have a context already.
    const auto device = static_cast<HDC>(device_);
    const HGLRC first = wglCreateContext(device);
    if (first == nullptr || wglMakeCurrent(device, first) == FALSE) {
        wglDeleteContext(first);
        return false;
    }
    CreateContextAttribs createContext = nullptr;
    void* address = getProcAddress("wglCreateContextAttribsARB");
    std::memcpy(&createContext, &address, sizeof(createContext));
    if (createContext != nullptr) {
        const int attributes[] = {
            kContextMajorVersion, 3, kContextMinorVersion, 3, kContextProfileMask,
            kContextCoreProfile,  0};
        context_ = createContext(device, nullptr, attributes);
    }
    wglMakeCurrent(nullptr, nullptr);
    wglDeleteContext(first);
    return context_ != nullptr && wglMakeCurrent(device, static_cast<HGLRC>(context_)) != FALSE;
}

HiddenWindow::~HiddenWindow() {
    if (context_ != nullptr) {
        wglMakeCurrent(nullptr, nullptr);
        wglDeleteContext(static_cast<HGLRC>(context_));
    }
    if (window_ != nullptr) {
        ReleaseDC(static_cast<HWND>(window_), static_cast<HDC>(device_));
        DestroyWindow(static_cast<HWND>(window_));
    }
}

void* HiddenWindow::getProcAddress(const char* name) {
    void* address = reinterpret_cast<void*>(wglGetProcAddress(name));
    const auto value = reinterpret_cast<std::intptr_t>(address);
    if (value >= -1 && value <= 3) { // drivers answer 0, 1, 2, 3 or -1 for what they do not have
        const HMODULE library = GetModuleHandleA("opengl32.dll");
        address = reinterpret_cast<void*>(GetProcAddress(library, name));
    }
    return address;
}
