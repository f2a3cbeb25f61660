#version 330 core
// The factor that samples of a pixel with several surfaces are multiplied by: each sample takes W from the
// pixels about it that show its surface. Over several samples it is the mean, background counting as 1.
#include "frame/host_samples.glsl"

uniform sampler2D uDepth;      // one for each pixel, as resolve_samples.frag and resolve_edges.frag wrote it
uniform sampler2D uEdges;      // resolve_edges.frag's
uniform sampler2D uVisibility; // W of uDepth's surfaces; -1 is background, or unknown
uniform ivec2 uOrigin;         // lower left corner of the host's viewport, pixels
uniform float uContrast;
uniform int uFirstSample;
uniform int uEndSample;

layout(location = 0) out vec4 outFactor;

// A pixel shows a sample's surface where it lies on its plane to within this many pixel footprints.
const float kSameSurface = 1.0;
// Pixels weigh 2^(-kNearness r^2), at r pixels from the sample.
const float kNearness = 2.0;
// Weight of a pixel that shows several surfaces itself: its W is of a surface that was continued.
const float kEdgeShare = 0.05;

vec3 samplePosition(ivec2 pixel, int index, float d) {
    return eyePosition(vec2(pixel) + samplePlace(index), linearDepth(d));
}

// Eye space, unit; towards the viewer where the surface does not go on to neighbours.
vec3 sampleNormal(ivec2 pixel, int index, float d, vec3 position, bool wanted) {
    vec2 slope = depthSlopes(pixel, index, d, wanted);
    // Over a small part of a pixel: a plane's depth values are linear, but may pass the far end's.
    const float kStep = 0.125;
    vec2 at = vec2(pixel) + samplePlace(index);
    vec3 right = eyePosition(at + vec2(kStep, 0.0), linearDepth(d + kStep * slope.x)) - position;
    vec3 up = eyePosition(at + vec2(0.0, kStep), linearDepth(d + kStep * slope.y)) - position;
    vec3 normal = cross(right, up);
    float size = dot(normal, normal);
    return size > 0.0 && !isinf(size) ? normal * inversesqrt(size) : towardsViewer(position);
}

// @param wanted  else nothing but the least of work: a software rasteriser runs it all the same
float sampleVisibility(ivec2 pixel, int index, bool wanted) {
    float d = sampleDepth(pixel, index);
    wanted = wanted && d != uDepthFar;
    float t = linearDepth(d);
    vec3 position = samplePosition(pixel, index, d);
    vec3 normal = sampleNormal(pixel, index, d, position, wanted);
    float tolerance = kSameSurface * pixelFootprint(t) + 2.0 * depthResolution(t);
    float sum = 0.0;
    float weights = 0.0;
    float nearest = 1.0e30;
    float best = 1.0;
    int i = 0;
    do {
        ivec2 other = pixel + ivec2(i % 3, i / 3) - 1;
        bool inside = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, ivec2(uViewSize)));
        other = inside ? other : pixel;
        float otherD = texelFetch(uDepth, other, 0).r;
        float w = texelFetch(uVisibility, other, 0).r;
        w = w < 0.0 ? 1.0 : w;
        vec3 otherPosition = eyePosition(vec2(other) + 0.5, linearDepth(otherD));
        float off = otherD == uDepthFar ? 1.0e30 : abs(dot(normal, otherPosition - position));
        vec2 away = vec2(other - pixel) + 0.5 - samplePlace(index);
        float weight = exp2(-kNearness * dot(away, away)) *
                       (texelFetch(uEdges, other, 0).r > 0.0 ? kEdgeShare : 1.0);
        weight = off <= tolerance ? weight : 0.0;
        sum += weight * w;
        weights += weight;
        best = off < nearest ? w : best;
        nearest = min(nearest, off);
    } while (wanted && ++i < 9);
    return !wanted ? 1.0 : weights > 0.0 ? sum / weights : best;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy) - uOrigin;
    bool edge = texelFetch(uEdges, pixel, 0).r > 0.0;
    float sum = 0.0;
    int index = uFirstSample;
    do {
        sum += sampleVisibility(pixel, index, edge);
    } while (edge && ++index < uEndSample);
    if (!edge) {
        discard;
    }
    float visibility = sum / float(uEndSample - uFirstSample);
    outFactor = vec4(vec3(1.0 - uContrast + uContrast * visibility), 1.0);
}
