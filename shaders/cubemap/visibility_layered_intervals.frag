#version 330 core
// Ambient occlusion of one face's texels from layered intervals, and their distances, as kept.
#include "cubemap/kept_texel.glsl"
#include "cubemap/layered_view.glsl"
#include "estimators/layered_intervals.glsl"

uniform int uFace;

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy) - ivec2(uFace * uFaceSize, 0));
    vec4 nearest = intervalAt(texel, 0);
    if (nearest.x < 0.0) {
        keepNothing();
        return;
    }
    vec3 position = rayOf(texel) * nearest.x;
    keep(visibilityLayeredIntervals(texel, position, decodeNormal(nearest.zw)), nearest.x);
}
