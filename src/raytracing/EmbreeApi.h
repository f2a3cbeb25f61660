#pragma once

/// The calls whose signatures differ between Embree 3 and 4, and the header's place.
/// `AOLIB_EMBREE_MAJOR` comes from the build, which knows which of the two it found.

#if AOLIB_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace aolib::embree {

/// Whether the rays of a packet start close together and point alike: another traversal is faster
/// then, and slower where they do not.
enum class Coherence : bool { Incoherent, Coherent };

#if AOLIB_EMBREE_MAJOR >= 4

inline void intersect(RTCScene scene, RTCRayHit& rayHit) {
    rtcIntersect1(scene, &rayHit);
}

inline void occluded(RTCScene scene, RTCRay& ray) {
    rtcOccluded1(scene, &ray);
}

inline RTCRayQueryFlags flagsOf(Coherence coherence) {
    return coherence == Coherence::Coherent ? RTC_RAY_QUERY_FLAG_COHERENT
                                            : RTC_RAY_QUERY_FLAG_INCOHERENT;
}

/// @param valid  -1 for lanes to trace, 0 for others.
inline void intersect(RTCScene scene, const int (&valid)[16], RTCRayHit16& rayHits,
                      Coherence coherence) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = flagsOf(coherence);
    rtcIntersect16(valid, scene, &rayHits, &arguments);
}

/// @param valid  -1 for lanes to trace, 0 for others.
inline void occluded(RTCScene scene, const int (&valid)[16], RTCRay16& rays, Coherence coherence) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = flagsOf(coherence);
    rtcOccluded16(valid, scene, &rays, &arguments);
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

inline RTCIntersectContext contextOf(Coherence coherence) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = coherence == Coherence::Coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                                     : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

/// @param valid  -1 for lanes to trace, 0 for others.
inline void intersect(RTCScene scene, const int (&valid)[16], RTCRayHit16& rayHits,
                      Coherence coherence) {
    RTCIntersectContext context = contextOf(coherence);
    rtcIntersect16(valid, scene, &context, &rayHits);
}

/// @param valid  -1 for lanes to trace, 0 for others.
inline void occluded(RTCScene scene, const int (&valid)[16], RTCRay16& rays, Coherence coherence) {
    RTCIntersectContext context = contextOf(coherence);
    rtcOccluded16(valid, scene, &context, &rays);
}

#endif

} // namespace aolib::embree
