#version 330 core
// Where each ray leaves the solid that it entered in the current layer. What lies behind a one-sided shell ends at
// the next surface, whichever it is.
#include "cubemap/peel.glsl"

uniform sampler2D uEntry; // distance, solid, normal

// Distance; 0 where there is no exit; negative where this surface is the other side of a shell, which
// begins nothing of its own.
layout(location = 0) out float outExit;

void main() {
    vec2 entry = texelFetch(uEntry, ivec2(gl_FragCoord.xy), 0).rg;
    float distance = length(vPosition);
    bool shell = entry.g == kShellEntry;
    bool leaves = shell ? distance > entry.r * (1.0 + kSameSurface)
                      : vSolid == entry.g && vSolid > 0.0 && !enters() && distance >= entry.r;
    if (entry.r < 0.0 || !leaves) {
        discard;
    }
    outExit = shell && closesShell() ? -distance : distance;
}
