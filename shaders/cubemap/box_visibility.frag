#version 330 core
// A fragment survives where the box's surface lies before what the cube map sees, or where the cube map
// knows nothing.
#include "shared/distance_code.h"

in float vDepth; // along the face's axis

uniform sampler2DArray uCubeDepth;
uniform int uLayer; // -1: the cube map keeps nothing of this face
uniform vec2 uDepthCode;

layout(location = 0) out vec4 outSeen;

void main() {
    float code = uLayer < 0 ? 0.0
                            : texelFetch(uCubeDepth, ivec3(ivec2(gl_FragCoord.xy), uLayer), 0).r;
    if (code > 0.0 && vDepth > decodeDistance(code, uDepthCode)) {
        discard;
    }
    outSeen = vec4(1.0);
}
