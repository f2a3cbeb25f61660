// Sectors of all directions, for which a surface keeps how open each is (docs/environment.md).
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

const int SECTOR_COUNT = 24;

// The sector of a direction, any length but zero: the faces of a cube, each in quarters. So the axis
// along which it is longest, and the signs of all three parts.
AO_FUNCTION int sectorOf(vec3 direction) {
    vec3 size = abs(direction);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 8 * axis + (direction.x > 0.0f ? 1 : 0) + (direction.y > 0.0f ? 2 : 0) +
           (direction.z > 0.0f ? 4 : 0);
}

AO_SHARED_END
