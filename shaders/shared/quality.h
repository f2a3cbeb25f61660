// Quality factor of a cube map for a surface point, Q = Qa Qb Qc with the thesis's three terms:
//   Qa = 1/d^2        nearer
//   Qb = cos^3(beta)  closer to the face's centre
//   Qc = cos(delta)   facing the cube map
// Qa and Qc are texels per area: a texel of an N x N face covers 4/N^2 cos^3(beta) of solid angle,
// and so 4/N^2 cos^3(beta) d^2/cos(delta) of a surface inclined by delta. By that count alone Qb would
// be 1/cos^3(beta); it is turned round because the estimators know least where a face ends.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// Q for a point at p from the cube's centre, with `distance2` = |p|^2, `depth` that of p along the face's
// axis and `facing` = -dot(normal, p). Its unit is 1 / length^2, and so are its powers in between: every
// scale holds.
AO_FUNCTION float qualityFactor(float distance2, float depth, float facing) {
    float inverse = 1.0f / distance2;
    return depth * depth * inverse * (depth * facing * inverse) * inverse;
}

AO_SHARED_END
