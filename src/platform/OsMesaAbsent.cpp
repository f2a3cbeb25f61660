#include "platform/OsMesaContext.h"

namespace aolib {

bool osMesaBuilt() {
    return false;
}

Result<std::unique_ptr<GlContext>> createOsMesaContext(const ContextRequest&) {
    return AoStatus(
        StatusCode::MissingCapability,
        "OSMesa: this build is without it (AOLIB_WITH_OSMESA was off, or GL/osmesa.h was "
        "not found).");
}

} // namespace aolib
