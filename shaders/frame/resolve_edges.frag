#version 330 core
// Pixels whose samples show several surfaces, among those that resolve_samples.frag has found.
#include "frame/host_samples.glsl"

uniform int uSampleCount;

layout(location = 0) out float outDepth; // of the nearest surface, continued to the pixel's centre
layout(location = 1) out float outEdge;  // (1 + a sample that shows it) / 255; 0 where there is one surface

// Samples whose linear depths differ by fewer pixel footprints count as one surface: what differs between them
// is as small as a pixel.
const float kAlikeFootprints = 1.0;
// The nearest surface is continued to at most this many times its depth, or to one over it.
const float kContinued = 2.0;

// The depth of sample `nearest`, continued over its plane to the pixel's centre.
float continuedDepth(ivec2 pixel, int nearest, float d) {
    float t = linearDepth(d);
    float centre = d + dot(depthSlopes(pixel, nearest, d, true), 0.5 - samplePlace(nearest));
    float ratio = linearDepth(centre) / t;
    bool sane = (centre - uDepthFar) * (d - uDepthFar) > 0.0 && ratio > 1.0 / kContinued &&
                ratio < kContinued;
    return sane ? centre : d;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float first = sampleDepth(pixel, 0);
    vec2 slope = depthSlopes(pixel, 0, first, true);
    float sum = 0.0;
    float miss = 0.0;
    float least = first;
    float most = first;
    int nearest = 0;
    float nearestDepth = first;
    for (int i = 0; i < uSampleCount; ++i) {
        float d = sampleDepth(pixel, i);
        sum += d;
        miss = max(miss, abs(first + dot(slope, samplePlace(i) - samplePlace(0)) - d));
        least = min(least, d);
        most = max(most, d);
        bool nearer = abs(d - uDepthFar) > abs(nearestDepth - uDepthFar);
        nearest = nearer ? i : nearest;
        nearestDepth = nearer ? d : nearestDepth;
    }
    float t = linearDepth(nearestDepth);
    float alike = kAlikeFootprints * pixelFootprint(t) + 4.0 * depthResolution(t);
    bool background = least == uDepthFar || most == uDepthFar;
    bool edge = least != most &&
                (background || (abs(linearDepth(most) - linearDepth(least)) > alike &&
                                miss > planeTolerance(linearDepth(first))));
    outDepth = edge            ? continuedDepth(pixel, nearest, nearestDepth)
               : least == most ? first
                               : sum / float(uSampleCount);
    outEdge = edge ? float(nearest + 1) / 255.0 : 0.0;
}
