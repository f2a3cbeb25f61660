// The samples of a multisampled host's depth. Each sample index by itself is a picture of one sample per
// pixel, displaced by where that sample lies, so surfaces are rebuilt within one index.
#include "frame/host_view.glsl"

uniform sampler2DMS uSamples;
uniform vec4 uSampleAt[32]; // x, y: place in the pixel, 0 to 1

// A surface goes on to a neighbour, and samples lie on one plane, to within this share of a footprint.
const float kOnePlaneFootprints = 0.3;

vec2 samplePlace(int index) { return uSampleAt[index].xy; }

float sampleDepth(ivec2 pixel, int index) {
    return texelFetch(uSamples, clamp(pixel, ivec2(0), ivec2(uViewSize) - 1), index).r;
}

// World units of linear depth for a step of 1 of the depth buffer's values, at linear depth t.
float depthScale(float t) { return depthResolution(t) / uDepthQuantum; }

// How far from a plane, in values of the depth buffer, is still on it.
float planeTolerance(float t) {
    return (kOnePlaneFootprints * pixelFootprint(t) + 4.0 * depthResolution(t)) / depthScale(t);
}

// Change of the depth buffer's value per pixel to the right and upwards, each on the side where the surface
// continues: there the next two values extrapolate to this one's best. 0 where it continues on neither side.
// @param wanted  else nothing but the least of work: a software rasteriser runs it all the same
vec2 depthSlopes(ivec2 pixel, int index, float d, bool wanted) {
    float tolerance = planeTolerance(linearDepth(d));
    vec2 slopes = vec2(0.0);
    int i = 0;
    do {
        ivec2 axis = ivec2(1 - i, i);
        float before1 = sampleDepth(pixel - axis, index);
        float after1 = sampleDepth(pixel + axis, index);
        float missBefore = abs(2.0 * before1 - sampleDepth(pixel - 2 * axis, index) - d);
        float missAfter = abs(2.0 * after1 - sampleDepth(pixel + 2 * axis, index) - d);
        bool afterInside = all(lessThan(pixel + axis, ivec2(uViewSize)));
        bool beforeInside = all(greaterThanEqual(pixel - axis, ivec2(0)));
        bool useAfter = afterInside && (!beforeInside || missAfter < missBefore);
        float slope = useAfter ? after1 - d : d - before1;
        slope = (useAfter ? missAfter : missBefore) > tolerance ? 0.0 : slope;
        slopes += slope * vec2(axis);
    } while (wanted && ++i < 2);
    return slopes;
}
