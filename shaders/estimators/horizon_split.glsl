// Horizon-split visibility (thesis 4.3.1, after Dimitrov, Bavoil and Sainz 2008):
//   W = 1 - 1/Nd Sum H(theta_i)^2,  H = the largest dot(n, direction to a sample) along direction i.
// Steps have a fixed world size, made a step in texture space by projecting P and P + dx t; samples
// that face away are skipped. Each rise of the horizon counts by the weight of the sample that raised
// it, which for `step` is the largest H within the radius.
//
// A falloff that reaches farther than the radius needs samples all about the view's centre C. Half
// slices, planes through C and P, then follow the horizon over all that they contain: from the tangent
// plane at P up to the direction towards C. Angles are from that direction, v, as in shared/slice.h.
//
// The including stage supplies the view that it runs in:
//   vec2 viewCoordinates(vec3 position)   texture coordinates of a position in front of the view
//   float viewDepth(vec3 position)        depth along the view's axis, positive in front
//   bool surfaceAt(vec2 uv, out vec3 position, out vec3 normal)   false where nothing was captured
//   vec2 viewTexel()                      size of a texel in texture coordinates
//   vec3 towardsCentre(vec3 position)     unit direction from a position to C
//   float arcLength(vec3 position, float reach)   of what a half slice shows of all within reach
//   float arcTexel()                      the least that is worth a step on it
//   float arcTurn(float arc)              the angle between the ray there and that to P
//   bool surfaceOnArc(vec3 position, vec3 v, vec3 tangent, float arc, out vec3, out vec3)
#include "shared/falloff.h"
#include "shared/slice.h"

uniform int uDirections;
uniform int uSteps;
uniform float uStepSize; // world units; of falloffs that end at the radius
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

// The angle from v at which a sample is seen, in a half slice whose horizon lies at `horizon`. The
// texel's own plane is off the slice's a little: between v and horizon it is measured in its own, so
// that a flat neighbour lies exactly on the horizon and hides nothing.
float angleSeen(vec3 toEmitter, vec3 normal, vec3 v, float horizon) {
    float along = dot(toEmitter, v);
    vec3 across = toEmitter - along * v;
    float size = length(across);
    float own = size > 0.0 ? atan(dot(normal, across) / size, dot(normal, v)) + 0.5 * kPi : horizon;
    return atan(size, along) * horizon / max(own, 1.0e-3);
}

// Occluded share of the half slice of cosine-weighted directions between v and its horizon.
float occlusionOnArc(vec3 position, vec3 normal, vec3 v, vec3 tangent, float gamma, float arc) {
    float end = gamma + 0.5 * kPi;
    float whole = sliceIntegral(end, gamma);
    float horizon = end;
    float before = end; // whence the next sample may hide: from beside what shows nothing
    float occlusion = 0.0;
    float at = 0.0;
    int j = 0;
    do { // asks at its end, as in layered_intervals.glsl
        // Steps grow with their number: fine near the receiver, where a texel subtends most.
        float share = float(++j) / float(uSteps);
        at = min(max(arc * share * share, at + arcTexel()), arc);
        vec3 emitter;
        vec3 emitterNormal;
        bool seen = surfaceOnArc(position, v, tangent, at, emitter, emitterNormal);
        vec3 toEmitter = emitter - position;
        float distance = length(toEmitter);
        bool faces = seen && distance > 0.0 && dot(toEmitter, emitterNormal) <= 0.0;
        float angle = faces ? angleSeen(toEmitter, normal, v, end) : end;
        float weight = angle < horizon ? occluderWeight(uFalloff, distance, uRadius) : 0.0;
        if (weight > 0.0) {
            float from = clamp(before, angle, horizon);
            occlusion += weight * (sliceIntegral(from, gamma) - sliceIntegral(angle, gamma));
            horizon = angle;
        }
        // Where nothing is seen, it is open in that direction, far away.
        before = seen ? end : kPi - arcTurn(at);
    } while (j < uSteps && at < arc);
    return occlusion / whole;
}

float visibilityWithoutRadius(vec3 position, vec3 normal) {
    vec3 v = towardsCentre(position);
    vec3 t;
    vec3 b;
    tangentFrame(v, t, b);
    float arc = arcLength(position, occluderReach(uFalloff, uRadius));
    vec2 sum = vec2(0.0);
    int i = 0;
    do {
        float phi = 2.0 * kPi * (float(i) + 0.5) / float(uDirections);
        vec3 tangent = cos(phi) * t + sin(phi) * b;
        vec3 across = cross(v, tangent);
        vec3 projected = normal - dot(normal, across) * across;
        float gamma = atan(dot(projected, tangent), dot(projected, v));
        float weight = length(projected) * sliceIntegral(gamma + 0.5 * kPi, gamma);
        if (weight > 1.0e-5) {
            sum += weight * vec2(occlusionOnArc(position, normal, v, tangent, gamma, arc), 1.0);
        }
    } while (++i < uDirections);
    return sum.y > 0.0 ? 1.0 - sum.x / sum.y : 1.0;
}

float visibilityWithinRadius(vec3 position, vec3 normal) {
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

float visibilityHorizonSplit(vec3 position, vec3 normal) {
    if (uFalloff == kFalloffStep) {
        return visibilityWithinRadius(position, normal);
    }
    return visibilityWithoutRadius(position, normal);
}
