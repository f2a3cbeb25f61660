// A slice of the hemisphere about a normal: the plane of a viewing direction v and a tangent t across
// it. theta is the angle from v towards t, gamma that of the normal's projection n_p into the slice.
// The cosine-weighted solid angle of a range of theta in a wedge of slices is proportional to
//   |n_p| (F(b) - F(a)),  F(theta) = antiderivative of cos(theta - gamma) |sin theta|.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// F(theta), zero at theta = 0.
AO_FUNCTION float sliceIntegral(float theta, float gamma) {
    float f = (cos(gamma) - cos(2.0f * theta - gamma)) * 0.25f + theta * sin(gamma) * 0.5f;
    return theta < 0.0f ? -f : f;
}

// The same up to a whole turn either way, for hemispheres that reach beyond -v.
AO_FUNCTION float sliceIntegralBeyond(float theta, float gamma) {
    float inside = sliceIntegral(theta, gamma);
    float halfTurn = 3.14159265358979f * sin(gamma); // twice F at a half turn
    float beyond = theta < 0.0f ? -inside + halfTurn : halfTurn - inside;
    return abs(theta) > 3.14159265358979f ? beyond : inside;
}

AO_SHARED_END
