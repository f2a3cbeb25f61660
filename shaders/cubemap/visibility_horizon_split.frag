#version 330 core
// Ambient occlusion of one face's texels by horizon split.
#include "cubemap/face_view.glsl"
#include "estimators/horizon_split.glsl"

uniform ivec2 uFaceOrigin; // where the face's first texel would lie in the target

layout(location = 0) out vec2 outFound; // blocked weight, weight

void main() {
    vec3 position;
    vec3 normal;
    ivec2 texel = ivec2(gl_FragCoord.xy) - uFaceOrigin;
    outFound = surfaceAtTexel(texel, position, normal)
                   ? vec2(1.0 - visibilityHorizonSplit(position, normal), 1.0)
                   : vec2(0.0);
}
