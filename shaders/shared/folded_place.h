// Where texels lie on their faces, the same for all that a turn of the cube onto itself takes to
// each other: what is hashed from it turns along.
#ifdef __cplusplus
#pragma once
#endif
#include "shared/cube_faces.h"
#include "shared/dual.h"

// A texel's place, turned in quarters about the middle of its face into the first quadrant.
struct FoldedPlace {
    ivec2 at; // from the middle, half texels
    int quarters;
};

AO_FUNCTION FoldedPlace foldedPlace(ivec2 texel, int faceSize) {
    ivec2 c = 2 * texel + 1 - faceSize;
    FoldedPlace place;
    place.quarters = c.x <= 0 && c.y > 0   ? 1
                     : c.x < 0 && c.y <= 0 ? 2
                     : c.x >= 0 && c.y < 0 ? 3
                                           : 0;
    place.at = place.quarters == 1   ? ivec2(c.y, -c.x)
               : place.quarters == 2 ? -c
               : place.quarters == 3 ? ivec2(-c.y, c.x)
                                     : c;
    return place;
}

// A face's direction to the right, turned by as many quarters.
AO_FUNCTION vec3 turnedRight(int face, int quarters) {
    vec3 axis = (quarters & 1) == 0 ? faceRight(face) : faceUp(face);
    return quarters < 2 ? axis : -axis;
}

AO_SHARED_END
