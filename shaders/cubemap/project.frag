#version 330 core
#extension GL_ARB_texture_gather : enable
// Projects cube maps onto the host's view, into a texture: those of one pass, on top of what earlier
// passes found.
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"
#include "cubemap/refined.glsl"

uniform sampler2D uBest; // of the passes before
uniform bool uFirstPass;
uniform int uFirstCube;
uniform int uEndCube;
uniform int uCubes;
uniform int uStride; // pixels from sample to sample: each is the last of so many

// Sum of visibility, quality (after the last pass its log2), code of cube map and face, weight.
layout(location = 0) out vec4 outBest;

const float kUnknown = -1.0e5; // log2 of quality where no cube map knows the surface
const float kGuess = -1000.0;  // and where what is nearby is known

// Share of a face, at its border, that the debug view darkens.
const float kBorder = 0.006;

// The best cube map's number and, below 1, its face.
float faceCode(Projected best) {
    vec2 edge = min(best.uv, 1.0 - best.uv);
    return float(best.cube) + (float(best.face) + (min(edge.x, edge.y) < kBorder ? 0.4 : 0.0)) / 8.0;
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(uStride * at + uStride - 1, ivec2(uViewSize) - 1);
    vec4 before = uFirstPass ? vec4(0.0) : texelFetch(uBest, at, 0);
    bool last = uEndCube == uCubes;
    outBest = last ? vec4(0.0, kUnknown, 0.0, 0.0) : before;
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        return;
    }
    Projected best = nothingProjected();
    best.sum = before.r;
    best.quality = before.g;
    best.weights = before.a;
    best.cube = int(before.b);
    vec3 eyeTo = uEyeToWorld * surface.eye;
    vec3 normal = uEyeToWorld * surface.normal;
    float resolution = depthResolution(surface.t);
    float longest = longestTexel(pixelFootprint(surface.t),
                                 dot(surface.normal, towardsViewer(surface.eye)));
    projectAll(uFirstCube, uEndCube, eyeTo, normal, resolution, longest, best);
    if (last) {
        for (int cube = 0; cube < uFirstCube; ++cube) {
            consider(cube, eyeTo, normal, best);
        }
        refine(eyeTo, normal, resolution, longest, best);
        float repaired = refinedVisibility(pixel, rawDepth(pixel));
        if (repaired >= 0.0) {
            best.sum = repaired;
            best.weights = 1.0;
        }
    }
    float code = best.quality > before.g || best.quality == 0.0 ? faceCode(best) : before.b;
    float known = best.quality > 0.0 ? log2(best.quality) : best.weights > 0.0 ? kGuess : kUnknown;
    outBest = vec4(best.sum, last ? known : best.quality, code, best.weights);
}
