#pragma once

#include <memory>

#include <aolib/Status.h>

#include "viewer/Window.h"

namespace aolib::viewer {

/// Dear ImGui in a window, for as long as it lives. Context: the window's.
class Gui {
public:
    /// After the window's own callbacks are set. The window must outlive it. Errors: ShaderError.
    static Result<std::unique_ptr<Gui>> create(const Window& window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    void beginFrame();
    /// Draws over what is in the framebuffer that is bound.
    void endFrame();

private:
    Gui() = default;
};

} // namespace aolib::viewer
