#include "platform/GlfwContext.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace aolib {
namespace {

void* glfwLoader(const char* name) {
    return reinterpret_cast<void*>(glfwGetProcAddress(name));
}

void releaseGlfw() {
    glfwMakeContextCurrent(nullptr);
}

AoStatus failure(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return {StatusCode::NoContext,
            "GLFW: " + what + (reason == nullptr ? "." : " (" + std::string(reason) + ").")};
}

class GlfwContext final : public GlContext {
public:
    explicit GlfwContext(GLFWwindow* window) : window_(window) {}
    ~GlfwContext() override;

    LoaderFunction loader() const override { return glfwLoader; }
    ContextRequest::Api api() const override { return ContextRequest::Api::Glfw; }
    std::string platformName() const override { return "GLFW window"; }
    void* nativeWindow() const override { return window_; }
    void swapBuffers() override { glfwSwapBuffers(window_); }

protected:
    AoStatus bind() override;
    bool isBound() const override { return glfwGetCurrentContext() == window_; }
    ReleaseFunction releaseFunction() const override { return releaseGlfw; }

private:
    GLFWwindow* window_;
};

GlfwContext::~GlfwContext() {
    doneCurrent();
    glfwDestroyWindow(window_);
}

AoStatus GlfwContext::bind() {
    glfwMakeContextCurrent(window_);
    return isBound() ? AoStatus() : failure("glfwMakeContextCurrent failed");
}

void setHints(const ContextRequest& request) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, request.major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, request.minor);
    if (request.major > 3 || (request.major == 3 && request.minor >= 2)) {
        glfwWindowHint(GLFW_OPENGL_PROFILE, request.profile == ContextRequest::Profile::Core
                                                ? GLFW_OPENGL_CORE_PROFILE
                                                : GLFW_OPENGL_COMPAT_PROFILE);
    }
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, request.debug ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, request.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_DEPTH_BITS, 24);
    glfwWindowHint(GLFW_STENCIL_BITS, 8);
    glfwWindowHint(GLFW_SAMPLES, request.samples);
}

} // namespace

bool glfwBuilt() {
    return true;
}

Result<std::unique_ptr<GlContext>> createGlfwContext(const ContextRequest& request) {
    // Once for the process, which also ends it: with glfwTerminate() after the last window, Mesa
    // would unload its driver, as EglDisplay.h tells.
    if (glfwInit() == GLFW_FALSE) {
        return failure("it cannot start");
    }
    setHints(request);
    GLFWwindow* window =
        glfwCreateWindow(request.width, request.height, request.title.c_str(), nullptr, nullptr);
    if (window == nullptr) {
        return failure("no window with an " + wantedContext(request));
    }
    return std::unique_ptr<GlContext>(std::make_unique<GlfwContext>(window));
}

} // namespace aolib
