#include "Display.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "platform/GlContext.h"

namespace {

class Window final : public Display {
public:
    explicit Window(GLFWwindow* window) : window_(window) {}
    ~Window() override { glfwDestroyWindow(window_); }

    GetProcAddress getProcAddress() const override {
        return [](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); };
    }
    bool open() const override { return glfwWindowShouldClose(window_) == GLFW_FALSE; }
    void show() override {
        glfwSwapBuffers(window_);
        glfwPollEvents();
    }

private:
    GLFWwindow* window_;
};

/// A context of aolib's own tools, for machines without a display.
class Offscreen final : public Display {
public:
    explicit Offscreen(std::unique_ptr<aolib::GlContext> context) : context_(std::move(context)) {}

    GetProcAddress getProcAddress() const override { return context_->loader(); }
    bool open() const override { return shown_ < kMostShown; }
    void show() override { ++shown_; }

private:
    /// Nobody closes it: so that what waits for a picture that never comes ends all the same.
    static constexpr int kMostShown = 10000;

    std::unique_ptr<aolib::GlContext> context_;
    int shown_ = 0;
};

} // namespace

std::unique_ptr<Display> Display::openWindow(int width, int height, std::string& reason) {
    GLFWwindow* window = nullptr;
    if (glfwInit() == GLFW_TRUE) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
        glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
        window = glfwCreateWindow(width, height, "aolib: minimal", nullptr, nullptr);
    }
    if (window == nullptr) {
        const char* why = nullptr;
        glfwGetError(&why);
        reason = "no window: " + std::string(why == nullptr ? "GLFW gives no reason" : why) +
                 "; --headless needs none";
        return nullptr;
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return std::make_unique<Window>(window);
}

std::unique_ptr<Display> Display::openOffscreen(int width, int height, std::string& reason) {
    aolib::ContextRequest request;
    request.defaultFramebuffer = true;
    request.width = width;
    request.height = height;
    auto context = aolib::createOffscreenContext(request);
    if (!context) {
        reason = context.status().message();
        return nullptr;
    }
    return std::make_unique<Offscreen>(std::move(*context));
}
