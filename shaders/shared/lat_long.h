// Maps by longitude and latitude: u = 1/2 is +X, u = 3/4 is +Z, v = 0 down, v = 1 up (+Y).
#ifdef __cplusplus
#pragma once
#endif
#include "shared/dual.h"

// Where a direction (any length but zero) lies on a map, 0 to 1 each way. GPU Gems, chapter 17,
// listing 17-4, but for its factor of theta: that makes v run to 2.
AO_FUNCTION vec2 latLongPlace(vec3 direction) {
    const float INVERSE_PI = 0.318309886f;
    // Not asin of a unit vector's y: near the poles that has lost half its digits.
    float level = length(vec2(direction.x, direction.z));
    return vec2(0.5f * INVERSE_PI * atan(direction.z, direction.x), INVERSE_PI * atan(direction.y, level)) +
           0.5f;
}

// The direction of a place on a map, unit length.
AO_FUNCTION vec3 latLongDirectionAt(vec2 place) {
    const float PI = 3.14159265f;
    float longitude = 2.0f * PI * (place.x - 0.5f);
    float latitude = PI * (place.y - 0.5f);
    return vec3(cos(latitude) * cos(longitude), sin(latitude), cos(latitude) * sin(longitude));
}

AO_SHARED_END
