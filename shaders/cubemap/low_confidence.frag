#version 330 core
#extension GL_ARB_texture_gather : enable
// Finds the pixels for whose visibility the cube maps have low confidence: the host's depth there, and
// -1 elsewhere. Where the host has samples (AO_SAMPLES), also where in the pixel its surface is seen, and
// the depth there: the surface of a pixel that shows several need not go on to the pixel's centre.
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"

uniform int uCubes;

#ifdef AO_SAMPLES
uniform sampler2D uEdges; // resolve_samples.frag's
uniform sampler2DMS uSamples;
uniform vec4 uSampleAt[32]; // as in frame/host_samples.glsl

layout(location = 0) out vec4 outDoubt; // depth, x and y in the pixel, depth there

void writeDoubt(ivec2 pixel, float d) {
    int nearest = int(255.0 * texelFetch(uEdges, pixel, 0).r + 0.5) - 1;
    outDoubt = nearest < 0 ? vec4(d, 0.5, 0.5, d)
                           : vec4(d, uSampleAt[nearest].xy, texelFetch(uSamples, pixel, nearest).r);
}

void writeNoDoubt() { outDoubt = vec4(-1.0); }
#else
layout(location = 0) out float outDoubt; // depth

void writeDoubt(ivec2 pixel, float d) { outDoubt = d; }

void writeNoDoubt() { outDoubt = -1.0; }
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    writeNoDoubt();
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        return;
    }
    vec3 eyeTo = uEyeToWorld * surface.eye;
    vec3 normal = uEyeToWorld * surface.normal;
    float resolution = depthResolution(surface.t);
    float longest = longestTexel(pixelFootprint(surface.t),
                                 dot(surface.normal, towardsViewer(surface.eye)));
    Projected best = nothingProjected();
    projectAll(0, uCubes, eyeTo, normal, resolution, longest, best);
    refine(eyeTo, normal, resolution, longest, best);
    float d = rawDepth(pixel);
    if (best.lowConfidence || isAlone(pixel, ivec2(1, 0), d, surface.t) ||
        isAlone(pixel, ivec2(0, 1), d, surface.t)) {
        writeDoubt(pixel, d);
    }
}
