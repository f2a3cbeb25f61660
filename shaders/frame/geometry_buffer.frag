#version 330 core
// The host's depth buffer as linear depth and world normal. Background: depth -1.
#include "frame/host_surface.glsl"
#include "shared/octahedral.h"

layout(location = 0) out float outDepth;
layout(location = 1) out vec2 outNormal;

void main() {
    HostSurface surface;
    if (!hostSurface(ivec2(gl_FragCoord.xy), surface)) {
        outDepth = -1.0;
        outNormal = vec2(0.0);
        return;
    }
    outDepth = surface.t;
    outNormal = encodeNormal(uEyeToWorld * surface.normal);
}
