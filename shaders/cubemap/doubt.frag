#version 330 core
#extension GL_ARB_texture_gather : enable
// Finds the pixels whose visibility the cube maps do not quite tell: the host's depth there, and
// -1 elsewhere.
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"

uniform int uCubes;

layout(location = 0) out float outDepth;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outDepth = -1.0;
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
    if (best.doubt || isAlone(pixel, ivec2(1, 0), d, surface.t) ||
        isAlone(pixel, ivec2(0, 1), d, surface.t)) {
        outDepth = d;
    }
}
