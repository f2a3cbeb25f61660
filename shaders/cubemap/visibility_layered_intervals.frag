#version 330 core
// Ambient occlusion of one face's texels from layered intervals: the slices of one pass.
#include "cubemap/layered_view.glsl"
#include "estimators/layered_intervals.glsl"

uniform int uFace;
uniform int uLayer;        // of surfaces, behind so many others
uniform ivec2 uFaceOrigin; // where the face's first texel would lie in the target
uniform int uFirstSlice;
uniform int uSliceCount;

layout(location = 0) out vec2 outFound; // blocked weight, weight

void main() {
    Texel texel = Texel(uFace, ivec2(gl_FragCoord.xy) - uFaceOrigin);
    bool onFace = texel.at == clamp(texel.at, ivec2(0), ivec2(uFaceSize - 1));
    vec4 surface = onFace ? intervalAt(texel, uLayer) : vec4(-1.0);
    outFound = surface.x < 0.0
                   ? vec2(0.0)
                   : blockedLayeredIntervals(texel, numberOf(texel), rayOf(texel) * surface.x,
                                             surface.zw, uFirstSlice, uSliceCount);
}
