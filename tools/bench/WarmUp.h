#pragma once

#include <aolib/AmbientOcclusion.h>
#include <glm/vec3.hpp>

#include "bench/HostedFrames.h"

namespace aolib::bench {

/// Takes options into force, without any cube map, after one small build and one frame, so that no
/// shader is compiled and no triangle uploaded while a clock runs.
/// @param place  where the small build stands, world units. Errors: those of the library. Context.
AoStatus warmUp(AmbientOcclusion& ao, HostedFrames& frames, const Options& options,
                const glm::vec3& place);

} // namespace aolib::bench
