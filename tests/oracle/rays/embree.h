// Embree 3 (Debian 12) or 4 (Debian 13): the two calls that differ.
#ifndef ORACLE_EMBREE_H
#define ORACLE_EMBREE_H

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>

inline void embree_intersect(RTCScene scene, RTCRayHit *ray)
{
    rtcIntersect1(scene, ray, nullptr);
}

inline void embree_occluded(RTCScene scene, RTCRay *ray)
{
    rtcOccluded1(scene, ray, nullptr);
}
#else
#include <embree3/rtcore.h>

inline void embree_intersect(RTCScene scene, RTCRayHit *ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, ray);
}

inline void embree_occluded(RTCScene scene, RTCRay *ray)
{
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, ray);
}
#endif

#endif
