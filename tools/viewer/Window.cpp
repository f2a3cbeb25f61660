#include "viewer/Window.h"

#include <algorithm>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace aolib::viewer {

namespace {

constexpr int kMinWidth = 480;
constexpr int kMinHeight = 320;

std::size_t indexOf(int button) {
    switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
        return static_cast<std::size_t>(MouseButton::Left);
    case GLFW_MOUSE_BUTTON_RIGHT:
        return static_cast<std::size_t>(MouseButton::Right);
    default:
        return static_cast<std::size_t>(MouseButton::Middle);
    }
}

} // namespace

Result<std::unique_ptr<Window>, app::Failure> Window::open(const Settings& settings) {
    ContextRequest request;
    request.api = ContextRequest::Api::Glfw;
    request.width = settings.width;
    request.height = settings.height;
    request.visible = true;
    request.title = "aolib view";
    Result<app::GlSession, app::Failure> session = app::GlSession::open(request, settings.strict);
    if (!session) {
        return session.error();
    }
    std::unique_ptr<Window> window(new Window(std::move(*session)));
    window->watch();
    return window;
}

Window::Window(app::GlSession session)
    : session_(std::make_unique<app::GlSession>(std::move(session))),
      window_(static_cast<GLFWwindow*>(session_->context().nativeWindow())) {}

Window::~Window() {
    glfwSetWindowUserPointer(window_, nullptr);
}

Window& Window::of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

/// Before the panels' own callbacks are set: those call these.
void Window::watch() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetWindowSizeLimits(window_, kMinWidth, kMinHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSwapInterval(1);
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        of(w).pressButton(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) {
        Window& self = of(w);
        self.stirred_ = true;
        if (!ImGui::GetIO().WantCaptureMouse) {
            self.input_.wheel += static_cast<float>(y);
        }
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
        Window& self = of(w);
        self.stirred_ = true;
        const bool control = (mods & GLFW_MOD_CONTROL) != 0;
        if (action == GLFW_PRESS && (control || !ImGui::GetIO().WantTextInput)) {
            self.input_.keys.push_back({key, control, (mods & GLFW_MOD_SHIFT) != 0});
        }
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        of(w).stirred_ = true;
        of(w).mouse_ = glm::vec2(x, y);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { of(w).stirred_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).stirred_ = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).stirred_ = true; });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        of(w).stirred_ = true;
        of(w).input_.dropped.assign(paths, paths + count);
    });
}

/// The mouse is where the latest event saw it, not where it is by now: the events of a long frame
/// come all at once, and what it did after the button went down is a drag.
void Window::pressButton(int button, bool down) {
    stirred_ = true;
    ButtonDrag& drag = input_.drags[indexOf(button)];
    if (down && mouse_.x < picture_ && !ImGui::GetIO().WantCaptureMouse) {
        drag.pressed = true;
        drag.held = true;
        drag.from = drag.to = mouse_;
    } else if (!down && drag.held) {
        extend(drag);
        drag.held = false;
    }
}

void Window::extend(ButtonDrag& drag) const {
    drag.by += mouse_ - drag.to;
    drag.to = mouse_;
}

void Window::wait(double seconds) {
    if (seconds < 0.0) {
        glfwWaitEvents();
    } else if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() {
    glfwPostEmptyEvent();
}

bool Window::keyHeld(int key) const {
    return !ImGui::GetIO().WantTextInput && glfwGetKey(window_, key) == GLFW_PRESS;
}

Input Window::takeInput(float picture) {
    picture_ = picture;
    for (ButtonDrag& drag : input_.drags) {
        if (drag.held) {
            extend(drag);
        }
    }
    const bool control = keyHeld(GLFW_KEY_LEFT_CONTROL) || keyHeld(GLFW_KEY_RIGHT_CONTROL);
    const auto axis = [&](int positive, int negative) {
        return control
                   ? 0.0F
                   : static_cast<float>(keyHeld(positive)) - static_cast<float>(keyHeld(negative));
    };
    input_.walk = {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                   axis(GLFW_KEY_W, GLFW_KEY_S)};
    input_.fast = keyHeld(GLFW_KEY_LEFT_SHIFT) || keyHeld(GLFW_KEY_RIGHT_SHIFT);
    Input taken = std::exchange(input_, {});
    for (std::size_t button = 0; button < taken.drags.size(); ++button) {
        input_.drags[button].held = taken.drags[button].held;
        input_.drags[button].to = taken.drags[button].to;
    }
    stirred_ = false;
    return taken;
}

bool Window::closing() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::resize(const glm::ivec2& size) {
    glfwSetWindowSize(window_, size.x, size.y);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

glm::ivec2 Window::size() const {
    glm::ivec2 size{0};
    glfwGetWindowSize(window_, &size.x, &size.y);
    return size;
}

glm::ivec2 Window::pixels() const {
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

float Window::contentScale() const {
    float x = 1.0F;
    float y = 1.0F;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(y, 1.0F);
}

} // namespace aolib::viewer
