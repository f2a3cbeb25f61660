#pragma once

#include "platform/GlContext.h"

namespace aolib {

/// A context without a window. Tries the platforms of findEglPlatforms() in turn.
/// Errors: see createContext(). On success the context is current: a platform counts as working
/// only if that worked, too.
Result<std::unique_ptr<GlContext>> createEglContext(const ContextRequest& request);

} // namespace aolib
