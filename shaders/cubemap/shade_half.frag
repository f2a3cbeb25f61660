#version 330 core
// shade.frag with a projection at half the resolution.
#include "cubemap/upsample.glsl"

uniform ivec2 uOrigin; // lower left corner of the host's viewport, pixels
uniform float uContrast;
uniform bool uKnownAlone; // else W is 1 where no cube map knows the surface

layout(location = 0) out vec4 outFactor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - uOrigin;
    HostSurface surface;
    if (!hostSurface(pixel, surface)) {
        discard;
    }
    vec4 projected = upsampled(pixel, surface);
    if (uKnownAlone && projected.a <= 0.0) {
        discard;
    }
    float visibility = projected.a > 0.0 ? projected.r : 1.0;
    outFactor = vec4(vec3(1.0 - uContrast + uContrast * visibility), 1.0);
}
