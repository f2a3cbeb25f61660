#version 330 core
// One depth per pixel of a multisampled host, and a first fallbackCube at the pixels that show several surfaces:
// one look at each sample, for all pixels.
#include "frame/host_samples.glsl"

uniform int uSampleCount;

layout(location = 0) out float outDepth; // at the pixel's centre, if its samples show one surface
layout(location = 1) out float outEdge;  // 1 where they may show several, for resolve_edges.frag; else 0

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float first = sampleDepth(pixel, 0);
    // Along the plane of the first samples of this pixel and its neighbours in the quad: values of a depth
    // buffer are linear on a plane.
    vec2 slope = vec2(dFdx(first), dFdy(first));
    float sum = first;
    float miss = 0.0;
    float least = first;
    float most = first;
    int i = 1;
    do {
        float d = sampleDepth(pixel, i);
        sum += d;
        miss = max(miss, abs(first + dot(slope, samplePlace(i) - samplePlace(0)) - d));
        least = min(least, d);
        most = max(most, d);
    } while (++i < uSampleCount);
    bool background = least == uDepthFar || most == uDepthFar;
    float t = linearDepth(least == uDepthFar ? most : least);
    outDepth = least == most ? first : sum / float(uSampleCount); // samples lie about the centre
    outEdge = least != most && (background || miss > planeTolerance(t)) ? 1.0 : 0.0;
}
