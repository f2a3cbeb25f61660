// Cube faces in the order +X -X +Y -Y +Z -Z. A face is a camera at the cube's centre that looks along
// `forward`, with `right` to the right and `up` upwards, field of view 90 degrees.
// Texture coordinates (u, v) of a face run from 0 to 1, right and up.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

AO_FUNCTION vec3 faceForward(int face) {
    float s = (face & 1) == 0 ? 1.0f : -1.0f;
    return face < 2 ? vec3(s, 0.0f, 0.0f) : face < 4 ? vec3(0.0f, s, 0.0f) : vec3(0.0f, 0.0f, s);
}

AO_FUNCTION vec3 faceUp(int face) {
    return face == 2   ? vec3(0.0f, 0.0f, 1.0f)
           : face == 3 ? vec3(0.0f, 0.0f, -1.0f)
                       : vec3(0.0f, 1.0f, 0.0f);
}

AO_FUNCTION vec3 faceRight(int face) { return cross(faceForward(face), faceUp(face)); }

// The face that a direction (not zero) falls on.
AO_FUNCTION int faceOf(vec3 direction) {
    vec3 a = abs(direction);
    if (a.x >= a.y && a.x >= a.z) {
        return direction.x >= 0.0f ? 0 : 1;
    }
    if (a.y >= a.z) {
        return direction.y >= 0.0f ? 2 : 3;
    }
    return direction.z >= 0.0f ? 4 : 5;
}

// Texture coordinates of a direction in front of a face; outside [0,1] when it belongs to another.
AO_FUNCTION vec2 faceCoordinates(int face, vec3 direction) {
    float depth = dot(direction, faceForward(face));
    return vec2(dot(direction, faceRight(face)), dot(direction, faceUp(face))) / depth * 0.5f + 0.5f;
}

// A vector in a face's own axes: right, up, forward.
AO_FUNCTION vec3 toFace(int face, vec3 v) {
    float s = (face & 1) == 0 ? 1.0f : -1.0f;
    return face < 2   ? vec3(s * v.z, v.y, s * v.x)
           : face < 4 ? vec3(v.x, s * v.z, s * v.y)
                      : vec3(-s * v.x, v.y, s * v.z);
}

// The direction through (u, v); its component along `forward` is 1, so it is not of unit length.
AO_FUNCTION vec3 faceDirection(int face, vec2 uv) {
    return faceForward(face) + (2.0f * uv.x - 1.0f) * faceRight(face) +
           (2.0f * uv.y - 1.0f) * faceUp(face);
}

AO_SHARED_END
