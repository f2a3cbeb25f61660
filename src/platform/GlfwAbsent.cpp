#include "platform/GlfwContext.h"

namespace aolib {

bool glfwBuilt() {
    return false;
}

Result<std::unique_ptr<GlContext>> createGlfwContext(const ContextRequest&) {
    return AoStatus(StatusCode::MissingCapability,
                    "GLFW: this build is without it (AOLIB_WITH_GLFW was off, or GLFW was not "
                    "found).");
}

} // namespace aolib
