#pragma once

/// The two calls whose signatures differ between Embree 3 and 4, and the header's place.
/// `AOLIB_EMBREE_MAJOR` comes from the build, which knows which of the two it found.

#if AOLIB_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace aolib::embree {

#if AOLIB_EMBREE_MAJOR >= 4

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
    rtcIntersect1(scene, &rayHit);
}

inline void occluded(RTCScene scene, RTCRay& ray) {
    rtcOccluded1(scene, &ray);
}

#else

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &rayHit);
}

inline void occluded(RTCScene scene, RTCRay& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}

#endif

} // namespace aolib::embree
