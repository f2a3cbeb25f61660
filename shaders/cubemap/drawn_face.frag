#version 330 core
// A face of a cube map that the host drew, from the depth that it left.
#include "frame/host_surface.glsl"
#include "shared/octahedral.h"

uniform ivec2 uOrigin; // of the face among the six, pixels

#ifdef AO_INTERVALS
layout(location = 0) out vec4 outSeen; // entry (-1 none), exit, octahedral normal

uniform float uThickness; // assumed of what is seen, world units

vec4 nothing() { return vec4(-1.0, -1.0, 0.0, 0.0); }
vec4 seen(float distance, vec3 normal) { return vec4(distance, distance + uThickness, encodeNormal(normal)); }
#else
layout(location = 0) out vec4 outSeen; // normal, distance (-1 nothing)

vec4 nothing() { return vec4(0.0, 0.0, 0.0, -1.0); }
vec4 seen(float distance, vec3 normal) { return vec4(normal, distance); }
#endif

void main() {
    HostSurface surface;
    bool found = hostSurface(ivec2(gl_FragCoord.xy) - uOrigin, surface);
    outSeen = found ? seen(length(surface.eye), uEyeToWorld * surface.normal) : nothing();
}
