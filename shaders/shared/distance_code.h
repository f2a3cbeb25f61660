// Depths of texels along their face's axis kept in 16 bits, 0 = nothing was hit. The bits of a float, read as a
// whole number, are its logarithm, straight between powers of two: a code is their place between those of the
// nearest and of the farthest depth, and decoding takes no exponential. The relative error is about the same
// everywhere, at most log2(farthest / nearest) / 131068: 8e-5 for a range of 1 to 1000.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// What codes span: bits of the nearest depth, and from there to those of the farthest.
AO_FUNCTION vec2 distanceSpan(float nearest, float farthest) {
    float least = float(floatBitsToInt(nearest));
    return vec2(least, float(floatBitsToInt(farthest)) - least);
}

// To the value of a normalised 16-bit channel.
AO_FUNCTION float encodeDistance(float distance, vec2 span) {
    float place = (float(floatBitsToInt(distance)) - span.x) / span.y;
    return (1.0f + 65534.0f * clamp(place, 0.0f, 1.0f)) / 65535.0f;
}

AO_FUNCTION float decodeDistance(float code, vec2 span) {
    return intBitsToFloat(int(span.x + (code * 65535.0f - 1.0f) / 65534.0f * span.y));
}

AO_SHARED_END
