// Two unit normals in two floats: that of a surface's plane, and the one that it is shaded about. Where
// both are one, octahedral coordinates as they are; else a whole number from 2 on for each coordinate,
// negative where the plane's is, of 13 bits of the plane's (to 0.005 degrees, axes and diagonals exactly)
// and 10 of the other's (to 0.1 degrees).
#ifdef __cplusplus
#pragma once
#endif
#include "shared/octahedral.h"

#include "shared/dual.h"

AO_FUNCTION float planeStep() { return 1.0f / 12288.0f; } // 2^12 times 3: below 2^24 with the rest
AO_FUNCTION float shadingSteps() { return 1024.0f; }
AO_FUNCTION float leastPair() { return 2.0f; } // above any coordinate that stands alone

AO_FUNCTION float encodePair(float plane, float shading) {
    float whole = floor(abs(plane) / planeStep() + 0.5f);
    float rest = floor((shading * 0.5f + 0.5f) * (shadingSteps() - 1.0f) + 0.5f);
    float pair = whole * shadingSteps() + rest + leastPair();
    return plane < 0.0f && whole > 0.0f ? -pair : pair;
}

AO_FUNCTION vec2 encodeNormals(vec3 plane, vec3 shading) {
    vec2 a = encodeNormal(plane);
    vec2 b = encodeNormal(shading);
    return vec2(encodePair(a.x, b.x), encodePair(a.y, b.y));
}

// (plane's, shading's) coordinate.
AO_FUNCTION vec2 decodePair(float pair) {
    float both = abs(pair) - leastPair();
    float whole = floor(both / shadingSteps());
    float rest = both - whole * shadingSteps();
    return vec2((pair < 0.0f ? -whole : whole) * planeStep(),
                rest / (shadingSteps() - 1.0f) * 2.0f - 1.0f);
}

AO_FUNCTION bool isPair(vec2 normals) { return abs(normals.x) >= leastPair(); }

AO_FUNCTION vec3 decodePlane(vec2 normals) {
    vec2 pair = vec2(decodePair(normals.x).x, decodePair(normals.y).x);
    return decodeNormal(isPair(normals) ? pair : normals);
}

AO_FUNCTION vec3 decodeShading(vec2 normals) {
    vec2 pair = vec2(decodePair(normals.x).y, decodePair(normals.y).y);
    return decodeNormal(isPair(normals) ? pair : normals);
}

AO_SHARED_END
