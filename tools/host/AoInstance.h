#pragma once

#include <aolib/AmbientOcclusion.h>

namespace aolib::host {

/// Gives an instance a tracer that takes all cores: a tool waits for the result. Errors: as
/// createTexelTracer().
AoStatus giveTracer(AmbientOcclusion& ao);

/// An instance for the current context that can trace rays, too. Errors: as
/// AmbientOcclusion::create() and createTexelTracer().
Result<AmbientOcclusion> createInstance(const ProcAddressLoader& loader,
                                        const Options& options = {});

} // namespace aolib::host
