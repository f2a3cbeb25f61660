#version 330 core
#extension GL_ARB_derivative_control : enable
// Screen-space AO for pixels that no cube map covers: what the host drew about them is a height field as
// thick as a constant. Half slices about the direction towards the viewer step over the picture; what
// they meet blocks sectors of the half slice. The four pixels of a quad take others each and share what
// they find (McGuire, Mara and Luebke 2012, "Scalable Ambient Obscurance"): as smooth as four times as many.
#include "frame/host_surface.glsl"
#include "shared/falloff.h"
#include "shared/sector_mask.h"
#include "shared/slice.h"

uniform sampler2D uMask; // project.frag's: known where its weight is above 0
uniform bool uUseMask;    // else what is known fails the depth test
uniform float uRadius;    // world units
uniform float uThickness; // world units
uniform int uFalloff;     // as enum class Falloff
uniform int uSides;       // half slices
uniform int uSteps;       // of each

layout(location = 0) out float outVisibility;

const float kPi = 3.14159265358979;
// The pixel's surface is lifted by this many footprints, and by what its depth may be wrong.
const float kLift = 0.1;
// Pixels of a quad share a surface that are this many footprints from each other's planes, at most.
const float kSameSurface = 0.5;
// Towards a tangent by so many pixels, to see where that leads in the picture.
const float kAhead = 8.0;

// A half slice: angles from the viewer, towards the tangent.
struct Side {
    vec3 viewer;  // unit
    vec3 tangent; // unit, across it
    float gamma;  // angle of the normal
    float span;   // its whole weight, but for the normal's length in the slice
};

// Pixels from `from` to the picture's border.
float toBorder(vec2 from, vec2 direction) {
    vec2 edge = mix(vec2(0.0), uViewSize, greaterThan(direction, vec2(0.0)));
    vec2 steps = abs(edge - from) / max(abs(direction), vec2(1.0e-6));
    return min(steps.x, steps.y);
}

// The sectors between two angles.
uvec2 sectorsOf(Side side, float low, float high) {
    float horizon = side.gamma + 0.5 * kPi;
    return sectorsBetween(sliceIntegral(min(low, horizon), side.gamma) / side.span,
                          sliceIntegral(min(high, horizon), side.gamma) / side.span);
}

float angleOf(Side side, vec3 to) {
    return acos(clamp(dot(to, side.viewer) * inversesqrt(max(dot(to, to), 1.0e-37)), -1.0, 1.0));
}

// Share of the side that is blocked by what the picture shows up to so many pixels away.
// @param first  of the steps, as a share of one
float blockedAlong(HostSurface surface, Side side, vec2 from, vec2 direction, float pixels,
                   float first) {
    uvec2 mask = uvec2(0u);
    float blocked = 0.0;
    float before = side.gamma + 0.5 * kPi;
    float depthBefore = surface.t;
    int step = 0;
    float reached = 0.0;
    do { // asks at its end, as in estimators/layered_intervals.glsl
        float share = (float(step++) + first) / float(uSteps);
        reached = max(pixels * share * share, float(step));
        ivec2 at = ivec2(floor(from + reached * direction));
        float d = rawDepth(at);
        float t = linearDepth(d);
        bool seen = d != uDepthFar && reached <= pixels;
        vec3 to = eyePosition(vec2(at) + 0.5, t) - surface.eye;
        float front = angleOf(side, to);
        float back = angleOf(side, to - uThickness * side.viewer);
        float weight = seen ? occluderWeight(uFalloff, length(to), uRadius) : 0.0;
        if (weight > 0.0) {
            // What is as deep as the sample before, or the pixel itself, is one surface with it.
            float joined = abs(t - depthBefore) < uThickness ? before : front;
            uvec2 sectors = sectorsOf(side, front, max(back, joined)) & ~mask;
            mask |= sectors;
            blocked += weight * shareSet(sectors);
        }
        before = front;
        depthBefore = seen ? t : -1.0e30;
    } while (step < uSteps && reached < pixels);
    return blocked;
}

// @param needed else nothing but the least of work: a software rasteriser runs it for pixels that need none
// @param turn   of the half slices, as a share of the angle between two
float screenSpaceVisibility(HostSurface surface, vec2 from, bool needed, float turn, float first) {
    vec3 viewer = towardsViewer(surface.eye);
    vec3 right = normalize(vec3(viewer.z, 0.0, -viewer.x));
    vec3 up = cross(viewer, right);
    float footprint = pixelFootprint(surface.t);
    surface.eye += (kLift * footprint + 2.0 * depthResolution(surface.t)) * surface.normal;
    vec2 sum = vec2(0.0);
    int i = 0;
    do {
        float phi = 2.0 * kPi * (float(i) + turn) / float(uSides);
        vec3 tangent = cos(phi) * right + sin(phi) * up;
        vec3 across = cross(viewer, tangent);
        vec3 projected = surface.normal - dot(surface.normal, across) * across;
        float gamma = atan(dot(projected, tangent), dot(projected, viewer));
        Side side = Side(viewer, tangent, gamma, sliceIntegral(gamma + 0.5 * kPi, gamma));
        float weight = length(projected) * side.span;
        vec2 direction = normalize(windowPosition(surface.eye + kAhead * footprint * tangent) - from);
        float pixels = needed ? min(occluderReach(uFalloff, uRadius) / footprint, toBorder(from, direction)) : 0.0;
        if (weight > 1.0e-5) {
            float blocked = blockedAlong(surface, side, from, direction, pixels, first);
            sum += weight * vec2(blocked, 1.0);
        }
    } while (needed && ++i < uSides);
    return sum.y > 0.0 ? clamp(1.0 - sum.x / sum.y, 0.0, 1.0) : 1.0;
}

#ifdef GL_ARB_derivative_control
#define ACROSS dFdxFine
#define UP dFdyFine
#else
#define ACROSS dFdx
#define UP dFdy
#endif

bool anyOfQuad(bool value) {
    float any = value ? 1.0 : 0.0;
    any += abs(ACROSS(any));
    return any + abs(UP(any)) > 0.0;
}

// The mean with a neighbour in the quad, at `side` half a pixel from the middle of the two, where both
// show one surface.
float meanWith(float visibility, float change, vec3 toOther, float missingChange, HostSurface surface,
               float side) {
    bool same = missingChange == 0.0 &&
                abs(dot(toOther, surface.normal)) <= kSameSurface * pixelFootprint(surface.t);
    return same ? visibility - side * change : visibility;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    HostSurface surface;
    bool drawn = hostSurface(pixel, surface);
    bool wanted = drawn && !(uUseMask && texelFetch(uMask, pixel, 0).a > 0.0);
    bool needed = drawn && anyOfQuad(wanted);
    ivec2 odd = pixel & 1;
    float w = screenSpaceVisibility(surface, vec2(pixel) + 0.5, needed,
                                0.25 * float(odd.x + 2 * odd.y) + 0.125,
                                1.0 - 0.25 * float((odd.x ^ odd.y) + 2 * odd.x));
    float missing = needed ? 0.0 : 1.0;
    vec2 side = vec2(odd) - 0.5;
    w = meanWith(w, ACROSS(w), ACROSS(surface.eye), ACROSS(missing), surface, side.x);
    w = meanWith(w, UP(w), UP(surface.eye), UP(missing), surface, side.y);
    if (!wanted) {
        discard; // not before: derivatives need whole quads
    }
    outVisibility = clamp(w, 0.0, 1.0);
}
