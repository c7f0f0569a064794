#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::geometry {

/// The point of the closed segment from a to b that is nearest to p. A segment may be a single point.
POLYGONAL_PERCEPTION_EXPORT Eigen::Vector2d nearestOnSegment(const Eigen::Vector2d& p,
                                                             const Eigen::Vector2d& a,
                                                             const Eigen::Vector2d& b);

/// A point on the boundary of polygons.
struct BoundaryPoint
{
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  double distance = 0.0;   ///< [m] from where it was asked for, inside as outside
  std::uint32_t ring = 0;  ///< index into PolygonSet::rings
  std::uint32_t edge = 0;  ///< of the ring, as RingView numbers them; the first of those equally near
};

/// The point on boundaries and holes' edges that is nearest to p.
///
/// @return nothing where there is no polygon
POLYGONAL_PERCEPTION_EXPORT std::optional<BoundaryPoint> nearestBoundaryPoint(const Eigen::Vector2d& p,
                                                                              const PolygonSet& polygons);

/// @return [m] how far p is from the nearest edge, inside as outside; infinite where there is none
POLYGONAL_PERCEPTION_EXPORT double distanceToBoundary(const Eigen::Vector2d& p, const RingView& ring);
POLYGONAL_PERCEPTION_EXPORT double distanceToBoundary(const Eigen::Vector2d& p, const PolygonSet& polygons);

}  // namespace polygonal_perception::geometry
