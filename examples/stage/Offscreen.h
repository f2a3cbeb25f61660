#pragma once

#include <memory>

#include "platform/GlContext.h"

namespace stage {

/// A context of aolib's own tools, current, with a framebuffer 0 of kWidth by kHeight; a host has
/// its own. Exits the program where there is none.
std::unique_ptr<aolib::GlContext> openContext(aolib::ContextRequest::Profile profile);

} // namespace stage
