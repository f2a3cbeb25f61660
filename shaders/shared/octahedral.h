// Unit vectors in two numbers of [-1,1]: octahedral map (Cigolle et al. 2014, "A Survey of Efficient
// Representations for Independent Unit Vectors").
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

AO_FUNCTION vec2 encodeNormal(vec3 n) {
    vec2 p = vec2(n.x, n.y) / (abs(n.x) + abs(n.y) + abs(n.z));
    vec2 signs = vec2(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f);
    return n.z >= 0.0f ? p : (1.0f - abs(vec2(p.y, p.x))) * signs;
}

AO_FUNCTION vec3 decodeNormal(vec2 e) {
    vec3 n = vec3(e.x, e.y, 1.0f - abs(e.x) - abs(e.y));
    if (n.z < 0.0f) {
        vec2 signs = vec2(n.x >= 0.0f ? 1.0f : -1.0f, n.y >= 0.0f ? 1.0f : -1.0f);
        vec2 folded = (1.0f - abs(vec2(n.y, n.x))) * signs;
        n = vec3(folded.x, folded.y, n.z);
    }
    return normalize(n);
}

AO_SHARED_END
