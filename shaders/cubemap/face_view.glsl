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

// What the cube map shows in a direction, whichever face that is on.
bool surfaceTowards(vec3 direction, out vec3 position, out vec3 normal) {
    int face = faceOf(direction);
    ivec2 texel = ivec2(faceCoordinates(face, direction) * float(uFaceSize));
    texel = clamp(texel, ivec2(0), ivec2(uFaceSize - 1));
    vec4 geometry = texelFetch(uGeometry, texel + ivec2(face * uFaceSize, 0), 0);
    vec2 uv = (vec2(texel) + 0.5) / float(uFaceSize);
    position = normalize(faceDirection(face, uv)) * geometry.w;
    normal = geometry.xyz;
    return geometry.w > 0.0;
}

vec2 viewCoordinates(vec3 position) { return faceCoordinates(uFace, position); }
float viewDepth(vec3 position) { return dot(position, faceForward(uFace)); }
vec2 viewTexel() { return vec2(1.0 / float(uFaceSize)); }

// An arc about the centre is measured in radians.
const float kHalfTurn = 3.14159265358979;

vec3 towardsCentre(vec3 position) { return -normalize(position); }
float arcLength(vec3 position, float reach) {
    float distance = length(position);
    return distance <= reach ? kHalfTurn : asin(reach / distance);
}
float arcTexel() { return 2.0 / float(uFaceSize); }
float arcTurn(float arc) { return arc; }
bool surfaceOnArc(vec3 position, vec3 v, vec3 tangent, float arc, out vec3 emitter, out vec3 normal) {
    return surfaceTowards(sin(arc) * tangent - cos(arc) * v, emitter, normal);
}
