#pragma once

// The one place that knows which Embree this is: version 3 and 4 differ in the header's folder and in how a
// packet of rays is cast.
#if POLYGONAL_PERCEPTION_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace polygonal_perception::simulation {

/// Finds the nearest hit of 16 rays that run close to each other; a hit that a ray already has stays if it is
/// nearer.
inline void intersectCoherent(const int* valid, RTCScene scene, RTCRayHit16* rays)
{
#if POLYGONAL_PERCEPTION_EMBREE_VERSION >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(valid, scene, rays, &arguments);
#else
  RTCIntersectContext context{};
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene, &context, rays);
#endif
}

}  // namespace polygonal_perception::simulation
