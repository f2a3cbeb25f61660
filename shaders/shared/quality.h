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

// log2 of Q for a point at `distance` whose ray has the cosine `cosBeta` to the face's axis and
// `cosDelta` to the surface normal. In logarithms, so that half floats hold every scale.
AO_FUNCTION float logQuality(float distance, float cosBeta, float cosDelta) {
    return -2.0f * log2(distance) + 3.0f * log2(cosBeta) + log2(cosDelta);
}

AO_SHARED_END
