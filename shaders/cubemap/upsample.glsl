// What the cube maps projected at half the resolution, taken to a pixel: the mean of the four nearest samples
// that lie on its tangent plane, bilinear; where none does, the one nearest to it.
#include "frame/host_surface.glsl"
#include "cubemap/refined.glsl"

uniform sampler2D uHalf; // project.frag's, a sample for each 2 x 2 pixels: at the upper right one

const float kOnPlaneFootprints = 1.0;
const vec4 kNothingTold = vec4(0.0, -1.0e5, 0.0, 0.0); // project.frag's kUnknown

ivec2 pixelOfSample(ivec2 at) { return min(2 * at + 1, ivec2(uViewSize) - 1); }

// As project.frag writes it, but for a weight of 1 or 0.
vec4 upsampled(ivec2 pixel, HostSurface surface) {
    ivec2 last = textureSize(uHalf, 0) - 1;
    vec2 place = 0.5 * vec2(pixel - 1);
    ivec2 base = ivec2(floor(place));
    vec2 f = place - vec2(base);
    float tolerance = kOnPlaneFootprints * pixelFootprint(surface.t) + 2.0 * depthResolution(surface.t);
    float sum = 0.0;
    float weights = 0.0;
    float nearest = 1.0e30;
    vec4 best = kNothingTold;
    for (int i = 0; i < 4; ++i) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 at = clamp(base + corner, ivec2(0), last);
        ivec2 other = pixelOfSample(at);
        vec4 projected = texelFetch(uHalf, at, 0);
        vec3 position = eyePosition(vec2(other) + 0.5, linearDepth(rawDepth(other)));
        float off = abs(dot(surface.normal, position - surface.eye));
        vec2 share = mix(1.0 - f, f, vec2(corner));
        float visibility = projected.a > 0.0 ? projected.r / projected.a : 1.0;
        float weight = projected.a > 0.0 && off <= tolerance ? share.x * share.y : 0.0;
        sum += weight * visibility;
        weights += weight;
        bool nearer = projected.a > 0.0 && off < nearest;
        best = nearer ? vec4(visibility, projected.gb, 1.0) : best;
        nearest = nearer ? off : nearest;
    }
    best.r = weights > 0.0 ? sum / weights : best.r;
    float repaired = refinedVisibility(pixel, rawDepth(pixel));
    return repaired < 0.0 ? best : vec4(repaired, best.gb, 1.0);
}
