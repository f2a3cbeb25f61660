#version 330 core
// Ambient occlusion of one face's texels from layered intervals: the slices of one pass.
#include "cubemap/layered_view.glsl"
#include "estimators/layered_intervals.glsl"

uniform int uFace;
uniform int uFirstSlice;
uniform int uSliceCount;

layout(location = 0) out vec2 outFound; // blocked weight, weight

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy) - ivec2(uFace * uFaceSize, 0));
    vec4 nearest = intervalAt(texel, 0);
    outFound = nearest.x < 0.0
                   ? vec2(0.0)
                   : blockedLayeredIntervals(texel, numberOf(texel), rayOf(texel) * nearest.x,
                                             decodeNormal(nearest.zw), uFirstSlice, uSliceCount);
}
