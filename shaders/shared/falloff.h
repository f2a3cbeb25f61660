// The weight w(L) of an occluder at distance L; numbers as in enum class Falloff.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

AO_FUNCTION float occluderWeight(int falloff, float distance, float radius) {
    if (falloff == 0) {
        return distance < radius ? 1.0f : 0.0f;
    }
    return falloff == 1 ? exp(-distance / radius) : 1.0f;
}

AO_SHARED_END
