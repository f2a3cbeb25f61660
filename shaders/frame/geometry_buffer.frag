#version 330 core
// The host's depth buffer as linear depth and world normal. Background: depth -1.
#include "frame/host_surface.glsl"
#include "shared/octahedral.h"

layout(location = 0) out float outDepth;
layout(location = 1) out vec2 outNormal;

#ifdef AO_HOST_NORMALS
uniform sampler2D uHostNormals; // world space
uniform vec2 uNormalCode;       // scale and offset that make vectors of what it holds

// A host's normal shorter than this is none: eight bits cannot distinguish 0 from 1/255.
const float kLeastNormal = 0.1;

// The host's normal where it gives one, on the side of the surface that is seen.
vec3 worldNormal(ivec2 pixel, vec3 seen) {
    vec3 given = texelFetch(uHostNormals, pixel, 0).xyz * uNormalCode.x + uNormalCode.y;
    float size = length(given);
    if (!(size > kLeastNormal) || isinf(size)) { // NaN is not greater
        return seen;
    }
    return (dot(given, seen) < 0.0 ? -given : given) / size;
}
#else
vec3 worldNormal(ivec2 pixel, vec3 seen) { return seen; }
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        outDepth = -1.0;
        outNormal = vec2(0.0);
        return;
    }
    outDepth = surface.t;
    outNormal = encodeNormal(worldNormal(pixel, uEyeToWorld * surface.normal));
}
