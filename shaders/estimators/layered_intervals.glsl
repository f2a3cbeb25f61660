// Visibility from layered solid intervals (docs/estimators.md). Every slice plane contains the cube's
// centre C and the receiver P, so that a cube map looked up by direction stays in it, across faces and
// without seams. Along each side of a slice, samples block wedges of a 64-sector mask whose sectors
// carry equal shares of the cosine-weighted hemisphere.
//
// The including stage supplies the view that it runs in, C being its centre:
//   struct Texel
//   bool texelTowards(vec3 direction, out Texel texel)   false where nothing is known
//   vec3 rayOf(Texel texel)                              unit direction of its middle
//   vec4 intervalAt(Texel texel, int layer)              entry (-1 none), exit, octahedral normal
//   int uLayers
//   float texelAngle(), float footprintAt(Texel, vec3 position), uint numberOf(Texel)
#include "shared/falloff.h"
#include "shared/sector_mask.h"
#include "shared/slice.h"

uniform int uSlices;
uniform int uSteps;      // per side
uniform float uRadius;   // world units
uniform int uFalloff;    // as enum class Falloff

const float kPi = 3.14159265358979;
// Steps grow as this power of their number: fine near the receiver, where a texel subtends most.
const float kStepPower = 1.5;
// The receiver is lifted off its surface by this many texel footprints.
const float kLift = 0.1;
// A sample's surface is continued along its tangent plane by at most this many step widths
// (docs/accuracy.md has the errors for others).
const float kExtension = 1.0;
// exp(-L / radius) is below 1% from here on, in radii.
const float kExpReach = 4.6;
const float kInfinite = 1.0e29;

struct Receiver {
    float distance; // from the cube's centre
    vec3 toCentre;  // unit, v
    vec3 normal;
    float reach; // of occluders, world units
    Texel texel;
};

// A slice side: theta runs from v towards `tangent`.
struct Side {
    vec3 tangent;
    float sign;  // +1 or -1: how its theta enters the slice's
    float gamma; // of the normal, on this side
};

struct Slice {
    float gamma;
    float low;  // F at the hemisphere's two ends
    float span; // F(high) - F(low): the slice's whole weight
};

// A reproducible number in [0,1) per texel (Jarzynski and Olano 2020, "Hash Functions for GPU
// Rendering", pcg).
float hash(uint x) {
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float((word >> 22u) ^ word) / 4294967296.0;
}

// The part of the ray at beta that lies in the ball of influence; x > y when it misses.
vec2 insideBall(Receiver p, float cosBeta, float sinBeta) {
    if (uFalloff == 2) {
        return vec2(0.0, kInfinite);
    }
    float across = p.distance * sinBeta;
    float half2 = p.reach * p.reach - across * across;
    float middle = p.distance * cosBeta;
    return half2 > 0.0 ? vec2(max(middle - sqrt(half2), 0.0), middle + sqrt(half2))
                       : vec2(1.0, -1.0);
}

// Cosine of the angle, from v, at which the point at distance r of the ray at beta is seen from the
// receiver: 1 towards the centre, -1 away from it.
float cosineSeen(Receiver p, float cosBeta, float sinBeta, float r) {
    vec2 q = r >= kInfinite ? vec2(-cosBeta, sinBeta)
                            : vec2(p.distance - r * cosBeta, r * sinBeta);
    return q.x * inversesqrt(max(dot(q, q), 1.0e-37));
}

// Distance along the ray at `beta` of the sample's tangent plane, at most `cap` from the sample.
float extended(float entry, float facing, float cosBeta, float sinBeta, float normalV,
               float normalT, float cap) {
    float facingThere = sinBeta * normalT - cosBeta * normalV;
    float r = facingThere < 0.0 ? entry * facing / facingThere : kInfinite;
    return clamp(r, max(entry - cap, 0.0), entry + cap);
}

// A sample's ray and the two rays between which it stands for what is there.
struct Wedge {
    vec3 ray;
    vec3 across; // unit, in the plane of v and the ray, across v
    vec2 beta;   // cosine and sine of the ray's angle from -v
    vec2 from;   // of the wedge's two sides
    vec2 to;
    vec2 ball; // what of each lies within reach
    vec2 ballFrom;
    vec2 ballTo;
    float width; // radians
};

// Cosines of the largest and the smallest angle, in the wedge's plane, that an interval blocks.
vec2 blockedCosines(Receiver p, Wedge w, vec4 interval) {
    float entry = interval.x;
    float exit = interval.y;
    vec3 normal = decodeNormal(interval.zw);
    float facing = dot(normal, w.ray);
    float normalV = dot(normal, p.toCentre);
    float normalT = dot(normal, w.across);
    float cap = kExtension * entry * w.width;
    bool sheet = exit <= entry;
    vec2 cosines = vec2(cosineSeen(p, w.beta.x, w.beta.y, min(exit, w.ball.y)),
                        cosineSeen(p, w.beta.x, w.beta.y, max(entry, w.ball.x)));
    float e = extended(entry, facing, w.from.x, w.from.y, normalV, normalT, cap);
    float x = sheet ? e : max(exit, e);
    if (e <= w.ballFrom.y && x >= w.ballFrom.x) {
        cosines.x = min(cosines.x, cosineSeen(p, w.from.x, w.from.y, min(x, w.ballFrom.y)));
        cosines.y = max(cosines.y, cosineSeen(p, w.from.x, w.from.y, max(e, w.ballFrom.x)));
    }
    e = extended(entry, facing, w.to.x, w.to.y, normalV, normalT, cap);
    x = sheet ? e : max(exit, e);
    if (e <= w.ballTo.y && x >= w.ballTo.x) {
        cosines.x = min(cosines.x, cosineSeen(p, w.to.x, w.to.y, min(x, w.ballTo.y)));
        cosines.y = max(cosines.y, cosineSeen(p, w.to.x, w.to.y, max(e, w.ballTo.x)));
    }
    return cosines;
}

// Weight of what an interval hides: by its point nearest to the receiver.
float intervalWeight(Receiver p, vec4 interval, float cosBeta) {
    if (uFalloff != 1) {
        return 1.0;
    }
    float r = clamp(p.distance * cosBeta, interval.x, max(interval.x, min(interval.y, kInfinite)));
    float distance2 = r * r - 2.0 * r * p.distance * cosBeta + p.distance * p.distance;
    return exp(-sqrt(max(distance2, 0.0)) / uRadius);
}

// Blocks the sectors of all intervals of one texel. `blocked` gathers their weight.
void blockTexel(Receiver p, Slice slice, Side side, Texel texel, float from, float to,
                inout uvec2 mask, inout float blocked) {
    Wedge w;
    w.ray = rayOf(texel);
    w.beta.x = -dot(w.ray, p.toCentre);
    w.across = w.ray + w.beta.x * p.toCentre;
    w.beta.y = length(w.across);
    if (!(w.beta.y > 0.0)) {
        return;
    }
    w.across /= w.beta.y;
    w.ball = insideBall(p, w.beta.x, w.beta.y);
    w.from = vec2(cos(from), sin(from));
    w.to = vec2(cos(to), sin(to));
    w.ballFrom = insideBall(p, w.from.x, w.from.y);
    w.ballTo = insideBall(p, w.to.x, w.to.y);
    w.width = to - from;
    // The texel's own plane, its horizon aligned to the slice's: a flat neighbour then lies exactly on
    // the horizon and hides nothing.
    float shift = side.gamma - atan(dot(p.normal, w.across), dot(p.normal, p.toCentre));
    for (int layer = 0; layer < uLayers; ++layer) {
        vec4 interval = intervalAt(texel, layer);
        if (interval.x < 0.0 || interval.x > w.ball.y) {
            break; // the layers come nearest first
        }
        if (interval.y < w.ball.x) {
            continue;
        }
        vec2 cosines = blockedCosines(p, w, interval);
        vec2 angles = (acos(clamp(cosines.yx, -1.0, 1.0)) + shift) * side.sign;
        angles = side.sign > 0.0 ? angles : angles.yx;
        angles = clamp(angles, slice.gamma - 0.5 * kPi, slice.gamma + 0.5 * kPi);
        float a = (sliceIntegral(angles.x, slice.gamma) - slice.low) / slice.span;
        float b = (sliceIntegral(angles.y, slice.gamma) - slice.low) / slice.span;
        uvec2 sectors = sectorsBetween(a, b) & ~mask;
        mask |= sectors;
        blocked += intervalWeight(p, interval, w.beta.x) * shareSet(sectors);
    }
}

// Share of the slice's weight that is blocked along one side.
float blockSide(Receiver p, Slice slice, Side side, float jitter, inout uvec2 mask) {
    float blocked = 0.0;
    float finest = texelAngle();
    float reach = uFalloff == 2 || p.distance <= p.reach ? kPi : asin(p.reach / p.distance);
    float from = 0.5 * finest;
    Texel before = p.texel;
    for (int j = 0; j < uSteps && from < reach; ++j) {
        float to = reach * pow(float(j + 1) / float(uSteps), kStepPower);
        to = max(to, from + finest);
        float beta = mix(from, to, jitter);
        Texel texel;
        bool known = texelTowards(sin(beta) * side.tangent - cos(beta) * p.toCentre, texel);
        if (known && texel != p.texel && texel != before) {
            blockTexel(p, slice, side, texel, from, min(to, kPi), mask, blocked);
            before = texel;
        }
        from = to;
    }
    return blocked;
}

float visibilityLayeredIntervals(Texel texel, vec3 position, vec3 normal) {
    Receiver p;
    position += kLift * footprintAt(texel, position) * normal;
    p.distance = length(position);
    p.toCentre = -position / p.distance;
    p.normal = normal;
    p.reach = uFalloff == 1 ? kExpReach * uRadius : uRadius;
    p.texel = texel;
    uint seed = numberOf(texel);
    float turn = hash(seed);
    vec3 right = normalize(cross(abs(p.toCentre.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0),
                                 p.toCentre));
    vec3 up = cross(p.toCentre, right);
    float blocked = 0.0;
    float weights = 0.0;
    for (int i = 0; i < uSlices; ++i) {
        float phi = kPi * (float(i) + turn) / float(uSlices);
        vec3 tangent = cos(phi) * right + sin(phi) * up;
        vec3 across = cross(p.toCentre, tangent);
        vec3 projected = normal - dot(normal, across) * across;
        float weight = length(projected);
        if (!(weight > 1.0e-5)) {
            continue;
        }
        Slice slice;
        slice.gamma = atan(dot(projected, tangent), dot(projected, p.toCentre));
        slice.low = sliceIntegral(slice.gamma - 0.5 * kPi, slice.gamma);
        slice.span = sliceIntegral(slice.gamma + 0.5 * kPi, slice.gamma) - slice.low;
        float jitter = hash(seed * 64u + uint(i));
        uvec2 mask = uvec2(0u);
        float share = 0.0;
        for (int k = 0; k < 2; ++k) {
            float sign = k == 0 ? 1.0 : -1.0;
            Side side = Side(sign * tangent, sign, sign * slice.gamma);
            share += blockSide(p, slice, side, k == 0 ? jitter : 1.0 - jitter, mask);
        }
        blocked += weight * slice.span * share;
        weights += weight * slice.span;
    }
    return weights > 0.0 ? 1.0 - blocked / weights : 1.0;
}
