#pragma once

#include <aolib/AmbientOcclusion.h>

namespace aolib::host {

/// An instance for the current context that can trace rays, too. Errors: as
/// AmbientOcclusion::create() and createTexelTracer().
Result<AmbientOcclusion> createInstance(const ProcAddressLoader& loader,
                                        const Options& options = {});

} // namespace aolib::host
