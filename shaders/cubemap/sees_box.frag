#version 330 core
// A fragment survives where the box's surface lies before what the cube map sees.
#include "shared/distance_code.h"

in vec3 vPosition;

uniform sampler2D uCubeDistance;
uniform int uFace;
uniform int uFaceSize;
uniform vec2 uDistanceCode;

layout(location = 0) out vec4 outSeen;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) + ivec2(uFace * uFaceSize, 0);
    float code = texelFetch(uCubeDistance, texel, 0).r;
    if (code > 0.0 && length(vPosition) > decodeDistance(code, uDistanceCode.x, uDistanceCode.y)) {
        discard;
    }
    outSeen = vec4(1.0);
}
