// A cube map captured as layers of solid intervals, looked up by direction from its centre: the view
// that estimators/layered_intervals.glsl runs in. With AO_VIEW_FACE, what a camera in the centre sees is
// looked up in its own, finer texels: a seventh face.
#include "shared/cube_faces.h"
#include "shared/folded_place.h"
#include "shared/normal_pair.h"

// The layers of each face, one face after the other: entry (-1 none), exit, normals as
// normal_pair.h has them.
uniform sampler2DArray uIntervals;
uniform ivec4 uFaceLayers[6]; // a face's first layer, how many it has
uniform int uLayers;
uniform int uFaceSize;
#ifdef AO_VIEW_FACE
uniform sampler2DArray uViewIntervals;
uniform int uViewLayers;
uniform mat3 uFrustum;     // rows x, y and w of clip space
uniform mat3 uFrustumRays; // its inverse
const int kViewFace = 6;
#endif

struct Texel {
    int face;
    ivec2 at; // within the face
};

// False where the view sees nothing that way: never, for a cube.
bool texelTowards(vec3 direction, out Texel texel) {
#ifdef AO_VIEW_FACE
    vec3 clip = uFrustum * direction;
    if (clip.z > 0.0 && max(abs(clip.x), abs(clip.y)) < clip.z) {
        ivec2 size = textureSize(uViewIntervals, 0).xy;
        texel.face = kViewFace;
        texel.at = min(ivec2((clip.xy / clip.z * 0.5 + 0.5) * vec2(size)), size - 1);
        return true;
    }
#endif
    texel.face = faceOf(direction);
    ivec2 at = ivec2(faceCoordinates(texel.face, direction) * float(uFaceSize));
    texel.at = clamp(at, ivec2(0), ivec2(uFaceSize - 1));
    return true;
}

#ifdef AO_VIEW_FACE
// World units that a texel of the view covers at the distance of one, square on.
float viewTexel() {
    return 2.0 * length(uFrustumRays[1]) / float(textureSize(uViewIntervals, 0).y);
}
#endif

// The angle that a texel subtends: at most, or of the view's.
float texelAngle() {
#ifdef AO_VIEW_FACE
    return viewTexel();
#else
    return 2.0 / float(uFaceSize);
#endif
}

// World units that a texel covers at a position, square on.
float footprintAt(Texel texel, vec3 position) {
#ifdef AO_VIEW_FACE
    if (texel.face == kViewFace) {
        return viewTexel() * (uFrustum * position).z;
    }
#endif
    return 2.0 * dot(position, faceForward(texel.face)) / float(uFaceSize);
}

// A number for each texel, which turns along with the cube.
uint numberOf(Texel texel) {
    ivec2 place = foldedPlace(texel.at, uFaceSize).at;
    return uint(place.x) + uint(2 * uFaceSize) * uint(place.y);
}

// A direction from which slices are counted, which does so, too; never that of the texel's ray.
vec3 slicesFrom(Texel texel) {
#ifdef AO_VIEW_FACE
    if (texel.face == kViewFace) {
        return normalize(uFrustumRays[0]);
    }
#endif
    return turnedRight(texel.face, foldedPlace(texel.at, uFaceSize).quarters);
}

vec3 rayOf(Texel texel) {
#ifdef AO_VIEW_FACE
    if (texel.face == kViewFace) {
        vec2 size = vec2(textureSize(uViewIntervals, 0).xy);
        return normalize(uFrustumRays * vec3((vec2(texel.at) + 0.5) / size * 2.0 - 1.0, 1.0));
    }
#endif
    return normalize(faceDirection(texel.face, (vec2(texel.at) + 0.5) / float(uFaceSize)));
}

// Entry, exit and normals of one layer; entry negative where there is none.
vec4 intervalAt(Texel texel, int layer) {
#ifdef AO_VIEW_FACE
    if (texel.face == kViewFace) {
        return layer < uViewLayers ? texelFetch(uViewIntervals, ivec3(texel.at, layer), 0) : vec4(-1.0);
    }
#endif
    ivec2 layers = uFaceLayers[texel.face].xy;
    return layer < layers.y ? texelFetch(uIntervals, ivec3(texel.at, layers.x + layer), 0) : vec4(-1.0);
}
