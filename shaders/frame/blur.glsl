// An edge-aware low-pass (thesis 4.5) over the pixels of one surface: along rows, then along columns.
// The including stage supplies what is summed:
//   vec2 sumsAt(ivec2 pixel)   of W, of how many pixels
#include "frame/geometry.glsl"
#include "frame/surface_edge.glsl"

uniform int uHalfSize; // the filter spans 2 uHalfSize + 1 pixels

const float kUnshaded = -1.0e4; // log2 of quality below this: no cube map

vec2 sumsAt(ivec2 pixel);

// @param t  linear depth of the pixel, which shows something
vec2 sumsAlong(ivec2 axis, ivec2 pixel, float t) {
    vec3 position = eyePositionAt(pixel, t);
    vec3 normal = worldNormalAt(pixel) * uEyeToWorld; // transpose: world to eye
    float tolerance = sameSurfaceTolerance(t);
    ivec2 last = ivec2(uViewSize) - 1;
    vec2 sums = vec2(0.0);
    int i = -uHalfSize;
    do { // asks at its end, as in estimators/layered_intervals.glsl
        ivec2 other = pixel + i * axis;
        if (all(greaterThanEqual(other, ivec2(0))) && all(lessThanEqual(other, last))) {
            float otherT = depthAt(other);
            if (otherT >= 0.0 && sameSurface(position, normal, tolerance, eyePositionAt(other, otherT),
                                             worldNormalAt(other) * uEyeToWorld)) {
                sums += sumsAt(other);
            }
        }
    } while (++i <= uHalfSize);
    return sums;
}
