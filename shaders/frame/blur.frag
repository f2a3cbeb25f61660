#version 330 core
// The second half of the blur: the mean over what the rows about a pixel have summed. Pixels that no
// cube map shades take the mean of those that are shaded: holes at silhouettes close.
#include "frame/blur.glsl"

uniform sampler2D uVisibility; // as blur_rows.frag reads it
uniform sampler2D uRows;       // what it wrote

// W or -1 for background; 1 shaded by a cube map, 0.5 filled from neighbours, 0 unshaded.
layout(location = 0) out vec2 outVisibility;

vec2 sumsAt(ivec2 pixel) { return texelFetch(uRows, pixel, 0).rg; }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float t = depthAt(pixel);
    if (t < 0.0) {
        outVisibility = vec2(-1.0, 0.0);
        return;
    }
    vec2 sums = sumsAlong(ivec2(0, 1), pixel, t);
    bool own = texelFetch(uVisibility, pixel, 0).g >= kUnshaded;
    outVisibility = vec2(sums.y > 0.0 ? sums.x / sums.y : 1.0, own ? 1.0 : sums.y > 0.0 ? 0.5 : 0.0);
}
