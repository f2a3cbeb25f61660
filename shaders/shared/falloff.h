// The weight w(L) of an occluder at distance L; numbers as in enum class Falloff.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

const int kFalloffStep = 0;
const int kFalloffExp = 1;
const int kFalloffOff = 2;

// exp(-L / radius) is below half a step of 16 bits, the finest that visibility is kept in, from here
// on, in radii: ln(2 * 65535) = 11.78.
const float kExpReach = 11.8f;
// A distance beyond all.
const float kEndless = 1.0e29f;

AO_FUNCTION float occluderWeight(int falloff, float distance, float radius) {
    if (falloff == kFalloffStep) {
        return distance < radius ? 1.0f : 0.0f;
    }
    return falloff == kFalloffExp ? exp(-distance / radius) : 1.0f;
}

// The distance from which on occluders have no weight.
AO_FUNCTION float occluderReach(int falloff, float radius) {
    return falloff == kFalloffStep ? radius : falloff == kFalloffExp ? kExpReach * radius : kEndless;
}

AO_SHARED_END
