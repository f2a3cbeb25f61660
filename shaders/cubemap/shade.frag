#version 330 core
#extension GL_ARB_texture_gather : enable
// Projects all cube maps and blends at once: the factor that the host's colours are multiplied by,
// (1 - a) + a W, thesis eq. 4.11.
#include "frame/host_surface.glsl"
#include "cubemap/projection.glsl"
#include "cubemap/refined.glsl"

uniform ivec2 uOrigin; // lower left corner of the host's viewport, pixels
uniform int uCubes;
uniform float uContrast;
uniform bool uKnownAlone; // else W is 1 where no cube map knows the surface

layout(location = 0) out vec4 outFactor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - uOrigin;
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        discard;
    }
    float visibility = refinedVisibility(pixel, rawDepth(pixel));
    if (visibility < 0.0) {
        vec3 eyeTo = uEyeToWorld * surface.eye;
        vec3 normal = uEyeToWorld * surface.normal;
        float resolution = depthResolution(surface.t);
        float longest = longestTexel(pixelFootprint(surface.t),
                                     dot(surface.normal, towardsViewer(surface.eye)));
        Projected best = nothingProjected();
        projectAll(0, uCubes, eyeTo, normal, resolution, longest, best);
        refine(eyeTo, normal, resolution, longest, best);
        if (uKnownAlone && best.weights <= 0.0) {
            discard;
        }
        visibility = best.weights > 0.0 ? best.sum / best.weights : 1.0;
    }
    outFactor = vec4(vec3(1.0 - uContrast + uContrast * visibility), 1.0);
}
