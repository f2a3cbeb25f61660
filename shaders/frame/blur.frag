#version 330 core
// Edge-aware low-pass (thesis 4.5) over the pixels of the same surface. Pixels that no cube map
// shades take the mean of those that are shaded: holes at silhouettes close.
#include "frame/geometry.glsl"
#include "frame/surface_edge.glsl"

uniform sampler2D uVisibility; // weighted sum of W, log2 of quality, unused, weight
uniform int uHalfSize;         // the filter spans 2 uHalfSize + 1 pixels

// W or -1 for background; 1 shaded by a cube map, 0.5 filled from neighbours, 0 unshaded.
layout(location = 0) out vec2 outVisibility;

const float kUnshaded = -1.0e4; // log2 of quality below this: no cube map

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float t = depthAt(pixel);
    if (t < 0.0) {
        outVisibility = vec2(-1.0, 0.0);
        return;
    }
    vec3 position = eyePositionAt(pixel, t);
    vec3 worldNormal = worldNormalAt(pixel);
    vec3 normal = worldNormal * uEyeToWorld; // transpose: world to eye
    float tolerance = sameSurfaceTolerance(t);
    float sum = 0.0;
    float count = 0.0;
    ivec2 last = ivec2(uViewSize) - 1;
    int y = -uHalfSize;
    do { // loops ask at their end, as in estimators/layered_intervals.glsl
        int x = -uHalfSize;
        do {
            ivec2 other = pixel + ivec2(x, y);
            if (all(greaterThanEqual(other, ivec2(0))) && all(lessThanEqual(other, last))) {
                float otherT = depthAt(other);
                vec4 visibility = texelFetch(uVisibility, other, 0);
                if (otherT >= 0.0 && visibility.g >= kUnshaded &&
                    sameSurface(position, normal, tolerance, eyePositionAt(other, otherT),
                                worldNormalAt(other) * uEyeToWorld)) {
                    sum += visibility.r / visibility.a;
                    count += 1.0;
                }
            }
        } while (++x <= uHalfSize);
    } while (++y <= uHalfSize);
    vec4 own = texelFetch(uVisibility, pixel, 0);
    float shaded = own.g >= kUnshaded ? 1.0 : count > 0.0 ? 0.5 : 0.0;
    outVisibility = vec2(count > 0.0 ? sum / count : 1.0, shaded);
}
