#pragma once

#include "platform/GlContext.h"

namespace aolib {

/// Whether this build can ask for OSMesa contexts (AOLIB_WITH_OSMESA, and its header was there).
bool osMesaBuilt();

/// A context of Mesa's software rasteriser that draws into client memory. The library is loaded
/// when the first one is asked for, hidden from the rest of the process, since it exports functions
/// of the same names as libGL; it stays loaded. Errors: see createContext().
Result<std::unique_ptr<GlContext>> createOsMesaContext(const ContextRequest& request);

} // namespace aolib
