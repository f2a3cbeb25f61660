#version 330 core
// What was found of pixels of a view at rest, as refined.glsl reads it.
uniform sampler2D uSums;  // blocked weight, weight
uniform sampler2D uDepth; // as the host drew it

layout(location = 0) out vec2 outFound; // visibility, depth (-1 nothing was found)

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 sums = texelFetch(uSums, pixel, 0).rg;
    outFound = sums.y > 0.0
                   ? vec2(clamp(1.0 - sums.x / sums.y, 0.0, 1.0), texelFetch(uDepth, pixel, 0).r)
                   : vec2(1.0, -1.0);
}
