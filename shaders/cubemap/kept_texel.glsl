// What a cube map keeps of a texel: 8 bits of visibility, 16 bits of depth along the face's axis.
#include "shared/distance_code.h"

uniform vec2 uDepthCode; // what codes of depth span

layout(location = 0) out float outVisibility;
layout(location = 1) out float outDepth;

void keepNothing() {
    outVisibility = 1.0;
    outDepth = 0.0;
}

void keep(float visibility, float depth) {
    outVisibility = clamp(visibility, 0.0, 1.0);
    outDepth = encodeDistance(depth, uDepthCode);
}
