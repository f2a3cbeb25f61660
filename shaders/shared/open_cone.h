// A cone that stands for the open directions of a surface (docs/environment.md).
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// A bent normal nearer to the horizon than this (its cosine) belongs to a surface that is all but
// closed: there is no telling how wide the cone is.
const float LEAST_BENT_COSINE = 0.05f;

// The squared sine of the half aperture of the cone about the bent normal that lets visibility W
// through: W = sin^2(a) * dot(normal, bentNormal) for a cone above the horizon.
AO_FUNCTION float coneShare(float visibility, float bentCosine) {
    return clamp(visibility / max(bentCosine, LEAST_BENT_COSINE), 0.0f, 1.0f);
}

// Half aperture over 90 degrees, from its squared sine.
AO_FUNCTION float coneAperture(float share) {
    const float TWO_OVER_PI = 0.636619772f;
    return TWO_OVER_PI * asin(sqrt(clamp(share, 0.0f, 1.0f)));
}

AO_SHARED_END
