// A cube map captured as layers of solid intervals, looked up by direction from its centre: the view
// that estimators/layered_intervals.glsl runs in.
#include "shared/cube_faces.h"
#include "shared/octahedral.h"

// The layers of each face, one face after the other: entry (-1 none), exit, octahedral normal.
uniform sampler2DArray uIntervals;
uniform ivec4 uFaceLayers[6]; // a face's first layer, how many it has
uniform int uLayers;
uniform int uFaceSize;

struct Texel {
    int face;
    ivec2 at; // within the face
};

// False where the view sees nothing that way: never, for a cube.
bool texelTowards(vec3 direction, out Texel texel) {
    texel.face = faceOf(direction);
    ivec2 at = ivec2(faceCoordinates(texel.face, direction) * float(uFaceSize));
    texel.at = clamp(at, ivec2(0), ivec2(uFaceSize - 1));
    return true;
}

// The angle that a texel subtends, at most.
float texelAngle() { return 2.0 / float(uFaceSize); }

// World units that a texel covers at a position, square on.
float footprintAt(Texel texel, vec3 position) {
    return 2.0 * dot(position, faceForward(texel.face)) / float(uFaceSize);
}

// A number of its own for each texel.
uint numberOf(Texel texel) {
    return uint(texel.at.x) + uint(uFaceSize) * (uint(texel.at.y) + uint(uFaceSize * texel.face));
}

vec3 rayOf(Texel texel) {
    return normalize(faceDirection(texel.face, (vec2(texel.at) + 0.5) / float(uFaceSize)));
}

// Entry, exit and normal of one layer; entry negative where there is none.
vec4 intervalAt(Texel texel, int layer) {
    ivec2 layers = uFaceLayers[texel.face].xy;
    return layer < layers.y ? texelFetch(uIntervals, ivec3(texel.at, layers.x + layer), 0) : vec4(-1.0);
}
