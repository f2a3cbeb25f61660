#version 330 core
// The projection at half the resolution as project.frag would have written it.
#include "cubemap/upsample.glsl"

layout(location = 0) out vec4 outBest;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    HostSurface surface;
    outBest = hostSurface(pixel, surface) ? upsampled(pixel, surface) : kNothingTold;
}
