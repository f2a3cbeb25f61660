#version 330 core
// Ambient occlusion of one face's texels by horizon split.
#include "cubemap/face_view.glsl"
#include "estimators/horizon_split.glsl"

layout(location = 0) out vec2 outFound; // blocked weight, weight

void main() {
    vec3 position;
    vec3 normal;
    ivec2 texel = ivec2(gl_FragCoord.xy) - ivec2(uFace * uFaceSize, 0);
    outFound = surfaceAtTexel(texel, position, normal)
                   ? vec2(1.0 - visibilityHorizonSplit(position, normal), 1.0)
                   : vec2(0.0);
}
