// Visibility from layered solid intervals (docs/estimators.md). Every slice plane contains the cube's
// centre C and the receiver P, so that a cube map looked up by direction stays in it, across faces and
// without seams. Along each side of a slice, samples block wedges of a 64-sector mask whose sectors
// carry equal shares of the cosine-weighted hemisphere.
//
// Loops ask at their end: a software rasteriser, which has no branches but a loop's way back, would run
// each body once more to find that nobody goes on.
//
// The including stage supplies the view that it runs in, C being its centre:
//   struct Texel
//   bool texelTowards(vec3 direction, out Texel texel)   false where nothing is known
//   vec3 rayOf(Texel texel)                              unit direction of its middle
//   vec4 intervalAt(Texel texel, int layer)              entry (-1 none), exit, normals
//   int uLayers
//   vec3 slicesFrom(Texel texel)                         whence slices are counted; not its ray
//   float texelAngle(), float footprintAt(Texel, vec3 position)
#include "shared/falloff.h"
#include "shared/normal_pair.h"
#include "shared/sector_mask.h"
#include "shared/slice.h"

uniform int uSlices;
uniform int uSliceStride; // coprime to uSlices: the order in which they are taken
uniform int uSteps;      // per side
uniform float uRadius;   // world units
uniform int uFalloff;    // as enum class Falloff

const float kPi = 3.14159265358979;
// The receiver is lifted off its surface by this many texel footprints.
const float kLift = 0.1;
// A sample's surface is continued along its tangent plane by at most this many step widths; an open mesh,
// which leaves no solid behind where it ends, by more (docs/accuracy.md has the errors for others). The
// finer the steps, the less is left to fallbackCube: stages with many define AO_FINE_STEPS.
#ifdef AO_FINE_STEPS
const float kExtension = 0.5;
const float kSheetExtension = 8.0;
#else
const float kExtension = 1.0;
const float kSheetExtension = 4.0;
#endif
// Cosine between ray and normal below which a surface's course between two rays is not known.
const float kEdgeOn = 1.0e-6;

struct Receiver {
    float distance; // from the cube's centre
    vec3 toCentre;  // unit, v
    vec3 normal; // what it is shaded about
    vec3 plane;  // of its surface: what lies below is blocked
    float reach; // of occluders, world units
    Texel texel;
};

// A slice side: theta runs from v towards `tangent`.
struct Side {
    vec3 tangent;
    float sign;    // +1 or -1: how its theta enters the slice's
    float plane;   // gamma of the surface's plane, on this side
    uvec2 sectors; // of the mask
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

// The part of a ray that lies in the ball of influence; x > y when it misses. Directions in a plane
// through the centre are (towards the centre as seen from the receiver, across): (-cos beta, sin beta).
vec2 insideBall(Receiver p, vec2 direction) {
    if (uFalloff == kFalloffOff) {
        return vec2(0.0, kEndless);
    }
    float across = p.distance * direction.y;
    float half2 = p.reach * p.reach - across * across;
    float middle = -p.distance * direction.x;
    return half2 > 0.0 ? vec2(max(middle - sqrt(half2), 0.0), middle + sqrt(half2))
                       : vec2(1.0, -1.0);
}

// Cosine of the angle, from v, at which the point at distance r of a ray is seen from the receiver: 1
// towards the centre, -1 away from it.
float cosineSeen(Receiver p, vec2 direction, float r) {
    vec2 q = r >= kEndless ? direction : vec2(r * direction.x + p.distance, r * direction.y);
    return q.x * inversesqrt(max(dot(q, q), 1.0e-37));
}

// A ray in a plane through the centre, and what of it lies within reach.
struct Ray {
    vec2 direction;
    vec2 ball;
};

Ray rayAt(Receiver p, float beta) {
    vec2 direction = vec2(-cos(beta), sin(beta));
    return Ray(direction, insideBall(p, direction));
}

// A sample's ray and the two rays between which it stands for what is there.
struct Wedge {
    vec3 ray;
    vec3 across; // unit, in the plane of v and the ray, across v
    Ray middle;
    Ray from;
    Ray to;
    float width; // radians
};

// An interval in the plane of its ray.
struct Segment {
    float entry;
    float exit;
    vec2 point;  // of entry
    vec2 normal; // of the surface there, projected
    vec2 along;  // unit, along the surface to where beta grows
    float facing;
    float cap; // how far the surface is continued, world units
};

// Takes in what the segment blocks on one side of the wedge: its surface, continued along its tangent
// plane up to the side's ray, or up to the cap where that is nearer, and its exit.
void continueTo(Receiver p, Segment s, Ray ray, float away, inout vec2 cosines) {
    float facing = dot(s.normal, ray.direction);
    float entry = s.entry * s.facing / facing;
    bool met = facing < 0.0 && abs(entry - s.entry) <= s.cap;
    entry = met ? entry : s.entry;
    float exit = max(s.exit, entry);
    if ((met || s.exit > s.entry) && entry <= ray.ball.y && exit >= ray.ball.x) {
        cosines.x = min(cosines.x, cosineSeen(p, ray.direction, min(exit, ray.ball.y)));
        cosines.y = met ? max(cosines.y, cosineSeen(p, ray.direction, max(entry, ray.ball.x)))
                        : cosines.y;
    }
    vec2 end = s.point + away * s.cap * s.along + vec2(p.distance, 0.0);
    float distance2 = dot(end, end);
    if (!met && (uFalloff == kFalloffOff || distance2 <= p.reach * p.reach)) {
        float cosine = end.x * inversesqrt(max(distance2, 1.0e-37));
        cosines = vec2(min(cosines.x, cosine), max(cosines.y, cosine));
    }
}

// Cosines of the largest and the smallest angle, in the wedge's plane, that an interval blocks.
vec2 blockedCosines(Receiver p, Wedge w, vec4 interval) {
    vec3 normal = decodePlane(interval.zw);
    Segment s;
    s.entry = interval.x;
    s.exit = interval.y;
    s.point = s.entry * w.middle.direction;
    s.normal = vec2(dot(normal, p.toCentre), dot(normal, w.across));
    s.facing = dot(s.normal, w.middle.direction);
    // The surface faces the ray: turned so, its normal's right is where beta grows.
    s.along = vec2(-s.normal.y, s.normal.x) * inversesqrt(max(dot(s.normal, s.normal), 1.0e-37));
    s.cap = (s.exit > s.entry ? kExtension : kSheetExtension) * s.entry * w.width;
    vec2 cosines = vec2(cosineSeen(p, w.middle.direction, min(s.exit, w.middle.ball.y)),
                        cosineSeen(p, w.middle.direction, max(s.entry, w.middle.ball.x)));
    if (s.facing < -kEdgeOn) {
        continueTo(p, s, w.from, -1.0, cosines);
        continueTo(p, s, w.to, 1.0, cosines);
    }
    return cosines;
}

// Weight of what an interval hides: by its point nearest to the receiver.
float intervalWeight(Receiver p, vec4 interval, float cosBeta) {
    if (uFalloff != kFalloffExp) {
        return 1.0;
    }
    float r = clamp(p.distance * cosBeta, interval.x, max(interval.x, min(interval.y, kEndless)));
    float distance2 = r * r - 2.0 * r * p.distance * cosBeta + p.distance * p.distance;
    return exp(-sqrt(max(distance2, 0.0)) / uRadius);
}

// Share of the hemisphere's weight up to an angle from v.
float shareUpTo(Slice slice, float angle) {
    angle = clamp(angle, slice.gamma - 0.5 * kPi, slice.gamma + 0.5 * kPi);
    return (sliceIntegral(angle, slice.gamma) - slice.low) / slice.span;
}

// The sectors between two angles from v, on one side.
uvec2 sectorsSeen(Slice slice, Side side, vec2 angles) {
    angles *= side.sign;
    angles = side.sign > 0.0 ? angles : angles.yx;
    return sectorsBetween(shareUpTo(slice, angles.x), shareUpTo(slice, angles.y));
}

// Blocks the sectors of all intervals of one texel. `blocked` gathers their weight.
void blockTexel(Receiver p, Slice slice, Side side, Texel texel, Ray from, Ray to, float width,
                inout uvec2 mask, inout float blocked) {
    Wedge w;
    w.ray = rayOf(texel);
    vec2 middle;
    middle.x = dot(w.ray, p.toCentre);
    w.across = w.ray - middle.x * p.toCentre;
    middle.y = length(w.across);
    if (!(middle.y > 0.0)) {
        return;
    }
    w.across /= middle.y;
    w.middle = Ray(middle, insideBall(p, middle));
    w.from = from;
    w.to = to;
    w.width = width;
    // The texel's own plane, its horizon aligned to the slice's: a flat neighbour then lies exactly on
    // the horizon and hides nothing.
    float shift = side.plane - atan(dot(p.plane, w.across), dot(p.plane, p.toCentre));
    int layer = 0;
    vec4 interval = intervalAt(texel, layer);
    bool within = interval.x >= 0.0 && interval.x <= w.middle.ball.y;
    do {
        if (within && interval.y >= w.middle.ball.x) {
            vec2 cosines = blockedCosines(p, w, interval);
            vec2 angles = acos(clamp(cosines.yx, -1.0, 1.0)) + shift;
            uvec2 sectors = sectorsSeen(slice, side, angles) & ~mask;
            mask |= sectors;
            blocked += intervalWeight(p, interval, -middle.x) * shareSet(sectors);
        }
        interval = intervalAt(texel, ++layer);
        within = within && layer < uLayers && interval.x >= 0.0 && interval.x <= w.middle.ball.y;
    } while (within); // the layers come nearest first
}

// Share of the slice's weight that is blocked along one side.
float blockSide(Receiver p, Slice slice, Side side, float jitter, inout uvec2 mask) {
    float blocked = 0.0;
    float finest = texelAngle();
    float reach = p.distance <= p.reach ? kPi : asin(p.reach / p.distance);
    float from = 0.5 * finest;
    Ray fromRay = rayAt(p, from);
    Texel before = p.texel;
    int step = 0;
    bool within = from < reach;
    do {
        // Steps grow with their number: fine near the receiver, where a texel subtends most.
        float share = float(++step) / float(uSteps);
        float to = min(max(reach * share * share, from + finest), kPi);
        Ray toRay = rayAt(p, to);
        vec2 between = mix(fromRay.direction, toRay.direction, jitter);
        Texel texel;
        bool known = texelTowards(between.y * side.tangent + between.x * p.toCentre, texel);
        if (within && known && texel != p.texel && texel != before) {
            blockTexel(p, slice, side, texel, fromRay, toRay, to - from, mask, blocked);
            before = texel;
        }
        from = to;
        fromRay = toRay;
        within = step < uSteps && from < reach;
        // Until all is blocked, at the latest: what comes then hides nothing more.
    } while (within && (mask & side.sectors) != side.sectors);
    return blocked;
}

// Weight that is blocked, and all weight, of the slice towards `tangent`.
vec2 blockedInSlice(Receiver p, vec3 tangent, float jitter) {
    vec3 across = cross(p.toCentre, tangent);
    vec3 projected = p.normal - dot(p.normal, across) * across;
    float weight = length(projected);
    if (!(weight > 1.0e-5)) {
        return vec2(0.0);
    }
    Slice slice;
    slice.gamma = atan(dot(projected, tangent), dot(projected, p.toCentre));
    vec3 level = p.plane - dot(p.plane, across) * across;
    float plane = atan(dot(level, tangent), dot(level, p.toCentre));
    // Of all angles that it is, the one next to the plane's, which faces the centre.
    slice.gamma += abs(plane - slice.gamma) > kPi ? 2.0 * kPi * sign(plane - slice.gamma) : 0.0;
    slice.low = sliceIntegralBeyond(slice.gamma - 0.5 * kPi, slice.gamma);
    slice.span = sliceIntegralBeyond(slice.gamma + 0.5 * kPi, slice.gamma) - slice.low;
    // What of the hemisphere lies below the surface's own plane is blocked.
    uvec2 mask = sectorsBetween(0.0, shareUpTo(slice, plane - 0.5 * kPi)) |
                 sectorsBetween(shareUpTo(slice, plane + 0.5 * kPi), 1.0);
    float share = shareSet(mask);
    float towardsCentre = -slice.low / slice.span; // F(0) = 0
    float sign = 1.0;
    do {
        uvec2 sectors = sign > 0.0 ? sectorsBetween(towardsCentre, 1.0)
                                   : sectorsBetween(0.0, towardsCentre);
        Side side = Side(sign * tangent, sign, sign * plane, sectors);
        share += blockSide(p, slice, side, sign > 0.0 ? jitter : 1.0 - jitter, mask);
        sign -= 2.0;
    } while (sign >= -1.0);
    return weight * slice.span * vec2(share, 1.0);
}

// Weight that is blocked, and all weight, of the slices from `first` to before `first + count`, of
// uSlices in all. Sums over all of them divide to 1 - W.
// @param texel  that shows what lies towards the position
// @param seed   another one for each receiver
vec2 blockedLayeredIntervals(Texel texel, uint seed, vec3 position, vec2 normals, int first,
                             int count) {
    Receiver p;
    p.plane = decodePlane(normals);
    p.normal = decodeShading(normals);
    position += kLift * footprintAt(texel, position) * p.plane;
    p.distance = length(position);
    p.toCentre = -position / p.distance;
    p.reach = occluderReach(uFalloff, uRadius);
    p.texel = texel;
    float turn = hash(seed);
    vec3 from = slicesFrom(texel);
    vec3 right = normalize(from - dot(from, p.toCentre) * p.toCentre);
    vec3 up = cross(p.toCentre, right);
    vec2 sum = vec2(0.0);
    // Each begins with another slice, so that receivers side by side know different ones from the first on.
    int begin = int(hash(~seed) * float(uSlices));
    int i = first;
    do {
        int number = (i * uSliceStride + begin) % uSlices;
        float phi = kPi * (float(number) + turn) / float(uSlices);
        sum += blockedInSlice(p, cos(phi) * right + sin(phi) * up, hash(seed * 64u + uint(number)));
    } while (++i < first + count);
    return sum;
}

float visibilityLayeredIntervals(Texel texel, uint seed, vec3 position, vec2 normals) {
    vec2 sum = blockedLayeredIntervals(texel, seed, position, normals, 0, uSlices);
    return sum.y > 0.0 ? 1.0 - sum.x / sum.y : 1.0;
}
