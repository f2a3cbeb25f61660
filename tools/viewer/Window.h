#pragma once

#include <memory>
#include <string>

#include <glm/vec2.hpp>

#include "app/GlSession.h"
#include "viewer/Input.h"

struct GLFWwindow;

namespace aolib::viewer {

/// The window and what happens to it. Thread: main only, but for wake().
class Window {
public:
    struct Settings {
        int width = 0;       ///< window pixels
        int height = 0;      ///< window pixels
        bool strict = false; ///< a debug context, whose messages are failures
    };

    /// Errors: Graphics.
    static Result<std::unique_ptr<Window>, app::Failure> open(const Settings& settings);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Waits for an event, but no longer than this, and takes all there are. 0 does not wait,
    /// below 0 waits without an end.
    void wait(double seconds);
    /// Has a wait() end. Threads: any.
    static void wake();

    /// What happened since the last call. @param picture  width of the picture, mouse pixels: what
    /// lies right of it is the panel's.
    Input takeInput(float picture);
    /// Whether anything happened since the last takeInput().
    bool stirred() const { return stirred_; }

    void show() { session_->context().swapBuffers(); }
    bool closing() const;
    void close();
    void resize(const glm::ivec2& size); ///< mouse pixels
    void setTitle(const std::string& title);

    glm::ivec2 size() const;    ///< mouse pixels
    glm::ivec2 pixels() const;  ///< of the framebuffer
    float contentScale() const; ///< of text, 1 where the screen is an ordinary one
    GLFWwindow* handle() const { return window_; }
    const app::GlSession& session() const { return *session_; }

private:
    explicit Window(app::GlSession session);
    void watch();
    void pressButton(int button, bool down);
    void extend(ButtonDrag& drag) const; ///< to where the mouse is
    bool keyHeld(int key) const;
    static Window& of(GLFWwindow* window);

    std::unique_ptr<app::GlSession> session_;
    GLFWwindow* window_ = nullptr;
    Input input_;           ///< since the last takeInput()
    float picture_ = 0.0F;  ///< mouse pixels
    glm::vec2 mouse_{0.0F}; ///< where the latest event saw it
    bool stirred_ = true;
};

} // namespace aolib::viewer
