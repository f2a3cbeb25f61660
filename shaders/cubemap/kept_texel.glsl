// What a cube map keeps of a texel: 8 bits of visibility, 16 bits of distance.
#include "shared/distance_code.h"

uniform vec2 uDistanceCode; // nearest distance, log2(farthest / nearest)

layout(location = 0) out float outVisibility;
layout(location = 1) out float outDistance;

void keepNothing() {
    outVisibility = 1.0;
    outDistance = 0.0;
}

void keep(float visibility, float distance) {
    outVisibility = clamp(visibility, 0.0, 1.0);
    outDistance = encodeDistance(distance, uDistanceCode.x, uDistanceCode.y);
}
