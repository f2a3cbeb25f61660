#pragma once

#include <optional>

#include <aolib/AbstractTexelTracer.h>
#include <aolib/Status.h>

#include "raytracing/RayScene.h"

namespace aolib {

/// Why a request cannot be traced: InvalidOption, InvalidPosition.
AoStatus checkRequest(const TexelRequest& request);

/// Traces a valid request; returns nothing if `keepGoing` returned false, which is called after
/// every 4096 rays at the latest. Throws std::bad_alloc.
std::optional<TracedTexels> traceRequest(const RayScene& scene, const TexelRequest& request,
                                         const KeepGoing& keepGoing);

} // namespace aolib
