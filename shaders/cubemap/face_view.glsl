// One face of a captured cube map as the view that an estimator runs in. Positions are relative to
// the cube's centre, in world axes.
#include "shared/cube_faces.h"

uniform sampler2D uGeometry; // six faces side by side: normal, distance; distance <= 0: nothing
uniform int uFace;
uniform int uFaceSize; // texels

vec3 texelRay(ivec2 texel) {
    return normalize(faceDirection(uFace, (vec2(texel) + 0.5) / float(uFaceSize)));
}

bool surfaceAtTexel(ivec2 texel, out vec3 position, out vec3 normal) {
    vec4 geometry = texelFetch(uGeometry, texel + ivec2(uFace * uFaceSize, 0), 0);
    position = texelRay(texel) * geometry.w;
    normal = geometry.xyz;
    return geometry.w > 0.0;
}

bool surfaceAt(vec2 uv, out vec3 position, out vec3 normal) {
    return surfaceAtTexel(ivec2(uv * float(uFaceSize)), position, normal);
}

vec2 viewCoordinates(vec3 position) { return faceCoordinates(uFace, position); }
float viewDepth(vec3 position) { return dot(position, faceForward(uFace)); }
vec2 viewTexel() { return vec2(1.0 / float(uFaceSize)); }
