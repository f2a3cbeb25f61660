#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>

#include <aolib/AbstractTexelTracer.h>

#include "scene/Bounds.h"

namespace aolib {

/// Texels as a FaceStore keeps them.
struct TexelCodes {
    std::vector<std::uint8_t> visibility;
    std::vector<std::uint16_t> depth;
};
/// @param sum   per texel: W times rays
/// @param code  as CubeMapProjector::depthCode()
TexelCodes encodeTexels(const TracedTexels& traced, const std::vector<float>& sum, int rays,
                        const glm::vec2& code);

/// What the texels of a request see.
struct SeenSurfaces {
    static constexpr float kInfinite = std::numeric_limits<float>::infinity();

    Bounds surfaces{glm::vec3(-kInfinite), glm::vec3(kInfinite)}; ///< world units
    float farthest = kInfinite; ///< distance, world units; infinite where a texel sees none
};
SeenSurfaces seenSurfaces(const TracedTexels& traced);

} // namespace aolib
