#version 330 core
// The host's depth buffer as linear depth and world normal. Background: depth -1.
#include "shared/octahedral.h"
#include "frame/host_view.glsl"

uniform sampler2D uDepth;

layout(location = 0) out float outDepth;
layout(location = 1) out vec2 outNormal;

float rawDepth(ivec2 pixel) {
    return texelFetch(uDepth, clamp(pixel, ivec2(0), ivec2(uViewSize) - 1), 0).r;
}

// The step from this pixel to its neighbour along `axis`, on the side where the surface continues:
// values of the depth buffer are linear on a plane, so that side is the one whose next two values
// extrapolate to this pixel's best.
vec3 surfaceStep(ivec2 pixel, ivec2 axis, float d, vec3 centre) {
    float before1 = rawDepth(pixel - axis);
    float before2 = rawDepth(pixel - 2 * axis);
    float after1 = rawDepth(pixel + axis);
    float after2 = rawDepth(pixel + 2 * axis);
    float missBefore = abs(2.0 * before1 - before2 - d);
    float missAfter = abs(2.0 * after1 - after2 - d);
    ivec2 limit = pixel + axis;
    bool afterInside = limit.x < int(uViewSize.x) && limit.y < int(uViewSize.y);
    limit = pixel - axis;
    bool beforeInside = limit.x >= 0 && limit.y >= 0;
    bool useAfter = afterInside && (!beforeInside || missAfter < missBefore);
    float side = useAfter ? 1.0 : -1.0;
    vec2 window = vec2(pixel) + 0.5 + side * vec2(axis);
    return side * (eyePosition(window, linearDepth(useAfter ? after1 : before1)) - centre);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float d = rawDepth(pixel);
    if (d == uDepthFar) {
        outDepth = -1.0;
        outNormal = vec2(0.0);
        return;
    }
    float t = linearDepth(d);
    vec3 centre = eyePosition(vec2(pixel) + 0.5, t);
    vec3 normal = cross(surfaceStep(pixel, ivec2(1, 0), d, centre),
                        surfaceStep(pixel, ivec2(0, 1), d, centre));
    vec3 viewer = towardsViewer(centre);
    float size = dot(normal, normal);
    normal = size > 0.0 && !isinf(size) ? normal * inversesqrt(size) : viewer;
    normal = dot(normal, viewer) < 0.0 ? -normal : normal;
    outDepth = t;
    outNormal = encodeNormal(uEyeToWorld * normal);
}
