#version 330 core
#extension GL_ARB_texture_gather : enable
// A sample of the host's view for a small target: what is where, and does a cube map shade it?
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"

uniform vec2 uTargetSize;
uniform int uCubes;

// From the eye to the surface, world axes; what the pixel covers there, world units, negative where no
// cube map shades it, 0 for background. The lowest bits of that number, kCubeMask, name the best cube map,
// or the one that might know the surface, kCubeMask where none does.
layout(location = 0) out vec4 outSample;

const int kCubeMask = 63; // as many as uCubeToEye names

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy / uTargetSize * uViewSize);
    outSample = vec4(0.0);
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
    int cube = best.quality > 0.0 ? best.cube : best.fallbackCube < 0 ? kCubeMask : best.fallbackCube;
    float footprint = intBitsToFloat((floatBitsToInt(pixelFootprint(surface.t)) & ~kCubeMask) | cube);
    outSample = vec4(eyeTo, best.weights > 0.0 ? footprint : -footprint);
}
