// The surface behind a pixel of the host's view, rebuilt from its depth buffer alone.
#include "frame/host_view.glsl"

uniform sampler2D uDepth; // as the host drew it

const float kAloneFootprints = 0.3;

float rawDepth(ivec2 pixel) {
    return texelFetch(uDepth, clamp(pixel, ivec2(0), ivec2(uViewSize) - 1), 0).r;
}

// The step from this pixel to its neighbour along `axis`, on the side where the surface continues:
// values of the depth buffer are linear on a plane, so that side is the one whose next two values
// extrapolate to this pixel's best.
vec3 surfaceStep(ivec2 pixel, ivec2 axis, float d, vec3 centre) {
    float before1 = rawDepth(pixel - axis);
    float before2 = rawDepth(pixel - 2 * axis);
    float after1 = rawDepth(pixel + axis);
    float after2 = rawDepth(pixel + 2 * axis);
    float missBefore = abs(2.0 * before1 - before2 - d);
    float missAfter = abs(2.0 * after1 - after2 - d);
    ivec2 limit = pixel + axis;
    bool afterInside = limit.x < int(uViewSize.x) && limit.y < int(uViewSize.y);
    limit = pixel - axis;
    bool beforeInside = limit.x >= 0 && limit.y >= 0;
    bool useAfter = afterInside && (!beforeInside || missAfter < missBefore);
    float side = useAfter ? 1.0 : -1.0;
    vec2 window = vec2(pixel) + 0.5 + side * vec2(axis);
    return side * (eyePosition(window, linearDepth(useAfter ? after1 : before1)) - centre);
}

// Whether a pixel's surface goes on to neither side along `axis`: to within a share of a pixel's
// footprint its neighbours do not lie in its plane, so that no normal can be computed.
bool isAlone(ivec2 pixel, ivec2 axis, float d, float t) {
    float missBefore = abs(2.0 * rawDepth(pixel - axis) - rawDepth(pixel - 2 * axis) - d);
    float missAfter = abs(2.0 * rawDepth(pixel + axis) - rawDepth(pixel + 2 * axis) - d);
    float perQuantum = depthResolution(t);
    return perQuantum / uDepthQuantum * min(missBefore, missAfter) >
           kAloneFootprints * pixelFootprint(t) + 4.0 * perQuantum;
}

struct HostSurface {
    float t;     // linear depth
    vec3 eye;    // position, eye space
    vec3 normal; // eye space, unit, towards the viewer
};

// False where nothing was drawn.
bool hostSurface(ivec2 pixel, out HostSurface surface) {
    float d = rawDepth(pixel);
    if (d == uDepthFar) {
        return false;
    }
    surface.t = linearDepth(d);
    surface.eye = eyePosition(vec2(pixel) + 0.5, surface.t);
    vec3 normal = cross(surfaceStep(pixel, ivec2(1, 0), d, surface.eye),
                        surfaceStep(pixel, ivec2(0, 1), d, surface.eye));
    vec3 viewer = towardsViewer(surface.eye);
    float size = dot(normal, normal);
    normal = size > 0.0 && !isinf(size) ? normal * inversesqrt(size) : viewer;
    surface.normal = dot(normal, viewer) < 0.0 ? -normal : normal;
    return true;
}
