#pragma once

#include "platform/GlContext.h"

namespace aolib {

/// Whether this build can open windows (AOLIB_WITH_GLFW, and GLFW was found).
bool glfwBuilt();

/// A window, hidden unless asked for, with its context. Thread: main only.
/// Errors: see createContext(); without a display server NoContext.
Result<std::unique_ptr<GlContext>> createGlfwContext(const ContextRequest& request);

} // namespace aolib
