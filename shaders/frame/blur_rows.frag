#version 330 core
// The first half of the blur: sums along a row of the picture, over the pixels of the same surface.
#include "frame/blur.glsl"

uniform sampler2D uVisibility; // weighted sum of W, log2 of quality, unused, weight

layout(location = 0) out vec2 outSums; // of W, of how many pixels that a cube map shades

vec2 sumsAt(ivec2 pixel) {
    vec4 visibility = texelFetch(uVisibility, pixel, 0);
    return visibility.g < kUnshaded ? vec2(0.0) : vec2(visibility.r / visibility.a, 1.0);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float t = depthAt(pixel);
    outSums = t < 0.0 ? vec2(0.0) : sumsAlong(ivec2(1, 0), pixel, t);
}
