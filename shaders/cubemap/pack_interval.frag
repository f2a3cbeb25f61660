#version 330 core
// One layer of solid intervals [entry, exit] from what was peeled. An open mesh has entry = exit; solid
// that nothing ends goes on without end.
#include "cubemap/entry_kinds.glsl"

uniform sampler2D uEntry; // distance, solid, normals
uniform sampler2D uExit;  // distance, 0 where there is none

layout(location = 0) out vec4 outInterval; // entry (-1 none), exit, normals

const float kInfinite = 1.0e30;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 entry = texelFetch(uEntry, texel, 0);
    if (entry.r < 0.0) {
        outInterval = vec4(-1.0, -1.0, 0.0, 0.0);
        return;
    }
    float exit = abs(texelFetch(uExit, texel, 0).r);
    outInterval = vec4(entry.r, exit > 0.0 ? exit : entry.g == kOpenMeshEntry ? entry.r : kInfinite,
                       entry.zw);
}
