#version 330 core
#extension GL_ARB_texture_gather : enable
// Projects cube maps onto the host's view, into a texture: those of one pass, on top of what earlier
// passes found.
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"
#include "cubemap/repaired.glsl"

uniform sampler2D uBest; // of the passes before
uniform bool uFirstPass;
uniform int uFirstCube;
uniform int uEndCube;
uniform int uCubes;

layout(location = 0) out vec4 outBest; // sum of visibility, log2 of quality, code of the face, weight

// Share of a face, at its border, that the debug view darkens.
const float kBorder = 0.006;

float faceCode(Projected best) {
    vec2 edge = min(best.uv, 1.0 - best.uv);
    return (float(best.face) + (min(edge.x, edge.y) < kBorder ? 0.4 : 0.0)) / 8.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 before = uFirstPass ? vec4(0.0, kUnknown, 0.0, 0.0) : texelFetch(uBest, pixel, 0);
    outBest = before;
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        return;
    }
    Projected best = nothingProjected();
    best.sum = before.r;
    best.quality = before.g;
    best.weights = before.a;
    vec3 eyeTo = uEyeToWorld * surface.eye;
    vec3 normal = uEyeToWorld * surface.normal;
    for (int cube = uFirstCube; cube < uEndCube; ++cube) {
        project(cube, eyeTo, normal, depthResolution(surface.t), best);
    }
    if (uEndCube == uCubes) {
        for (int cube = 0; cube < uFirstCube; ++cube) {
            consider(cube, eyeTo, normal, best);
        }
        guess(eyeTo, best);
        float repaired = repairedVisibility(pixel, rawDepth(pixel));
        if (repaired >= 0.0) {
            best.sum = repaired;
            best.weights = 1.0;
            best.quality = max(best.quality, kGuess);
        }
    }
    outBest = vec4(best.sum, best.quality,
                   best.quality > before.g ? faceCode(best) : before.b, best.weights);
}
