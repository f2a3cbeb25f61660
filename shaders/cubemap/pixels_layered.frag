#version 330 core
// Ambient occlusion of the pixels of a view at rest, from layered intervals about its eye: the slices of
// one pass.
#define AO_VIEW_FACE
#include "frame/host_view.glsl"
#include "cubemap/layered_view.glsl"
#define AO_FINE_STEPS
#include "estimators/layered_intervals.glsl"

uniform sampler2D uDepth; // as the host drew it
uniform int uFirstSlice;
uniform int uSliceCount;

// The triangle is what the host has drawn when its distance agrees to within this share of a pixel's
// footprint.
const float kReach = 0.25;

layout(location = 0) out vec2 outFound; // blocked weight, weight

// A pixel's surface relative to the eye, world axes, as the triangle has it that is seen there: the depth
// buffer does not hold the normals of what is one pixel wide. False where the host has drawn nothing, or what
// the scene does not have.
bool receiverAt(ivec2 pixel, out vec3 position, out vec2 normals) {
    float d = texelFetch(uDepth, pixel, 0).r;
    float t = linearDepth(d);
    vec3 eye = eyePosition(vec2(pixel) + 0.5, t);
    float distance = length(eye);
    vec4 seen = intervalAt(Texel(kViewFace, pixel), 0);
    position = uEyeToWorld * eye * (seen.x / distance);
    normals = seen.zw;
    float along = distance / t; // world units for each of depth
    float reach = 2.0 * along * depthResolution(t) + kReach * pixelFootprint(t);
    return d != uDepthFar && seen.x > 0.0 && abs(seen.x - distance) <= reach;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 position;
    vec2 normals;
    Texel texel;
    outFound = vec2(0.0);
    if (receiverAt(pixel, position, normals)) {
        texelTowards(position, texel);
        outFound = blockedLayeredIntervals(texel, uint(pixel.x) + uint(uViewSize.x) * uint(pixel.y),
                                           position, normals, uFirstSlice, uSliceCount);
    }
}
