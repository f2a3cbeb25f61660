#version 330 core
// Ambient occlusion of one face's texels by horizon split, and their distances, as they are kept.
#include "cubemap/face_view.glsl"
#include "cubemap/kept_texel.glsl"
#include "estimators/horizon_split.glsl"

void main() {
    vec3 position;
    vec3 normal;
    ivec2 texel = ivec2(gl_FragCoord.xy) - ivec2(uFace * uFaceSize, 0);
    if (!surfaceAtTexel(texel, position, normal)) {
        keepNothing();
        return;
    }
    keep(visibilityHorizonSplit(position, normal), length(position));
}
