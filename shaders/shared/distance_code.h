// Depths of texels along their face's axis kept in 16 bits: code = 1 + 65534 * log(d / nearest) / log(farthest /
// nearest), 0 = nothing was hit. The relative error is the same everywhere, at most
// (farthest / nearest)^(1 / 131068) - 1: 5e-5 for a range of 1 to 1000.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// To the value of a normalised 16-bit channel. `range` is log2(farthest / nearest).
AO_FUNCTION float encodeDistance(float distance, float nearest, float range) {
    return (1.0f + 65534.0f * clamp(log2(distance / nearest) / range, 0.0f, 1.0f)) / 65535.0f;
}

AO_FUNCTION float decodeDistance(float code, float nearest, float range) {
    return nearest * exp2((code * 65535.0f - 1.0f) / 65534.0f * range);
}

AO_SHARED_END
