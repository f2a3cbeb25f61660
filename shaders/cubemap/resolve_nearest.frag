#version 330 core
// What is kept of a face's texels whose estimate needs no smoothing.
#include "cubemap/face_view.glsl"
#include "cubemap/kept_texel.glsl"

uniform sampler2D uAccumulated; // six faces side by side: blocked weight, weight

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec3 position;
    vec3 normal;
    if (!surfaceAtTexel(texel, position, normal)) {
        keepNothing();
        return;
    }
    vec2 found = texelFetch(uAccumulated, texel + ivec2(uFace * uFaceSize, 0), 0).rg;
    keep(found.y > 0.0 ? 1.0 - found.x / found.y : 1.0, viewDepth(position));
}
