#version 330 core
// One depth per pixel of a multisampled host, and the pixels whose samples show several surfaces.
#include "frame/host_samples.glsl"

uniform int uSampleCount;

// At the pixel's centre: of the one surface; where there are several, of the nearest one, continued.
layout(location = 0) out float outDepth;
// 0 where the samples show one surface or none; else (1 + a sample of the nearest surface) / 255.
layout(location = 1) out float outEdge;

// Samples whose linear depths differ by fewer pixel footprints need no test: what tells them apart is as
// small as a pixel.
const float kAlikeFootprints = 1.0;
// The nearest surface is continued to at most this many times its depth, or to one over it.
const float kContinued = 2.0;

// The depth of sample `nearest`, continued over its plane to the pixel's centre.
float continuedDepth(ivec2 pixel, int nearest, float d) {
    float t = linearDepth(d);
    float tolerance = planeTolerance(t);
    vec2 slope = vec2(depthSlope(pixel, ivec2(1, 0), nearest, d, tolerance),
                      depthSlope(pixel, ivec2(0, 1), nearest, d, tolerance));
    float centre = d + dot(slope, 0.5 - samplePlace(nearest));
    float ratio = linearDepth(centre) / t;
    bool sane = (centre - uDepthFar) * (d - uDepthFar) > 0.0 && ratio > 1.0 / kContinued &&
                ratio < kContinued;
    return sane ? centre : d;
}

// Whether all samples lie on the plane through the first and its neighbours.
bool onOnePlane(ivec2 pixel, float first) {
    float tolerance = planeTolerance(linearDepth(first));
    vec2 slope = vec2(depthSlope(pixel, ivec2(1, 0), 0, first, tolerance),
                      depthSlope(pixel, ivec2(0, 1), 0, first, tolerance));
    bool plane = true;
    for (int i = 1; i < uSampleCount; ++i) {
        float onPlane = first + dot(slope, samplePlace(i) - samplePlace(0));
        plane = plane && abs(sampleDepth(pixel, i) - onPlane) <= tolerance;
    }
    return plane;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float first = sampleDepth(pixel, 0);
    float least = first;
    float most = first;
    float sum = first;
    int nearest = 0;
    float nearestDepth = first;
    for (int i = 1; i < uSampleCount; ++i) {
        float d = sampleDepth(pixel, i);
        least = min(least, d);
        most = max(most, d);
        sum += d;
        bool nearer = abs(d - uDepthFar) > abs(nearestDepth - uDepthFar);
        nearest = nearer ? i : nearest;
        nearestDepth = nearer ? d : nearestDepth;
    }
    bool background = least == uDepthFar || most == uDepthFar;
    outDepth = least == most ? first : sum / float(uSampleCount); // samples lie about the centre
    outEdge = 0.0;
    float t = linearDepth(nearestDepth);
    bool unlike = least != most && (background || abs(linearDepth(most) - linearDepth(least)) >
                                                      kAlikeFootprints * pixelFootprint(t) +
                                                          4.0 * depthResolution(t));
    if (unlike && (background || !onOnePlane(pixel, first))) {
        outDepth = continuedDepth(pixel, nearest, nearestDepth);
        outEdge = float(nearest + 1) / 255.0;
    }
}
