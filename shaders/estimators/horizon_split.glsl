// Horizon-split visibility (thesis 4.3.1, after Dimitrov, Bavoil and Sainz 2008):
//   W = 1 - 1/Nd Sum H(theta_i)^2,  H = the largest dot(n, direction to a sample) along direction i.
// Steps have a fixed world size, made a step in texture space by projecting P and P + dx t; samples
// that face away are skipped. With a falloff, each rise of the horizon counts by the weight of the
// sample that raised it, which for `step` is the largest H within the radius.
//
// The including stage supplies the view that it runs in:
//   vec2 viewCoordinates(vec3 position)   texture coordinates of a position in front of the view
//   float viewDepth(vec3 position)        depth along the view's axis, positive in front
//   bool surfaceAt(vec2 uv, out vec3 position, out vec3 normal)   false where nothing was captured
//   vec2 viewTexel()                      size of a texel in texture coordinates
#include "shared/falloff.h"

uniform int uDirections;
uniform int uSteps;
uniform float uStepSize; // world units
uniform float uRadius;   // world units
uniform int uFalloff;

const float kPi = 3.14159265358979;
// The point that gives the step's direction stays in front of this share of the receiver's depth.
const float kNearestStepDepth = 0.1;

// Two unit vectors that span the plane across n (Duff et al. 2017).
void tangentFrame(vec3 n, out vec3 t, out vec3 b) {
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float c = n.x * n.y * a;
    t = vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x);
    b = vec3(c, s + n.y * n.y * a, -n.y);
}

// The step of world size dx along the tangent t, in texture coordinates.
vec2 textureStep(vec3 position, vec2 uv, vec3 t) {
    float depth = viewDepth(position);
    float stepped = viewDepth(position + uStepSize * t);
    // Where the step would reach behind the view, take the direction from a shorter one.
    float scale = min(1.0, (1.0 - kNearestStepDepth) * depth / max(depth - stepped, 1.0e-30 * depth));
    scale = stepped > kNearestStepDepth * depth ? 1.0 : scale;
    return (viewCoordinates(position + scale * uStepSize * t) - uv) / scale;
}

bool isInside(vec2 uv) { return all(greaterThanEqual(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0))); }

// Occlusion Sum w dH^2 along one direction.
float occlusionAlong(vec3 position, vec3 normal, vec2 uv, vec2 stepUv) {
    float pixels = max(abs(stepUv.x) / viewTexel().x, abs(stepUv.y) / viewTexel().y);
    vec2 firstTexel = stepUv / max(pixels, 1.0e-6);
    float horizon = 0.0;
    float occlusion = 0.0;
    int j = 0;
    vec2 at = uv + firstTexel;
    bool inside = isInside(at);
    do { // asks at its end, as in layered_intervals.glsl
        vec3 emitter = position;
        vec3 emitterNormal = normal;
        bool seen = surfaceAt(inside ? at : uv, emitter, emitterNormal);
        vec3 toEmitter = emitter - position;
        float distance = length(toEmitter);
        bool faces = seen && inside && distance > 0.0 && dot(toEmitter, emitterNormal) <= 0.0;
        float height = faces ? dot(normal, toEmitter) / distance : 0.0;
        // A sample without weight does not hide those behind it.
        float weight = height > horizon ? occluderWeight(uFalloff, distance, uRadius) : 0.0;
        if (weight > 0.0) {
            occlusion += weight * (height * height - horizon * horizon);
            horizon = height;
        }
        at = uv + firstTexel + float(++j) * stepUv;
        inside = inside && j < uSteps && isInside(at);
    } while (inside);
    return occlusion;
}

float visibilityHorizonSplit(vec3 position, vec3 normal) {
    vec3 t;
    vec3 b;
    tangentFrame(normal, t, b);
    vec2 uv = viewCoordinates(position);
    float occlusion = 0.0;
    int i = 0;
    do {
        float theta = 2.0 * kPi * (float(i) + 0.5) / float(uDirections);
        vec2 stepUv = textureStep(position, uv, cos(theta) * t + sin(theta) * b);
        occlusion += occlusionAlong(position, normal, uv, stepUv);
    } while (++i < uDirections);
    return 1.0 - occlusion / float(uDirections);
}
