#version 330 core
// Where each ray leaves the solid that it entered in the current layer.
#include "cubemap/peel.glsl"

uniform sampler2D uEntry; // distance, solid, normal

layout(location = 0) out float outExit;

void main() {
    vec2 entry = texelFetch(uEntry, ivec2(gl_FragCoord.xy), 0).rg;
    float distance = length(vPosition);
    if (entry.r < 0.0 || vSolid != entry.g || enters() || distance < entry.r) {
        discard;
    }
    outExit = distance;
}
