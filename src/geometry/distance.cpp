#include "polygonal_perception/geometry/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polygonal_perception::geometry {

Eigen::Vector2d nearestOnSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  const Eigen::Vector2d along = b - a;
  const double squared_length = along.squaredNorm();
  if (squared_length == 0.0) return a;
  const double share = (p - a).dot(along) / squared_length;
  if (share >= 1.0) return b;
  return a + std::max(0.0, share) * along;
}

std::optional<BoundaryPoint> nearestBoundaryPoint(const Eigen::Vector2d& p, const PolygonSet& polygons)
{
  std::optional<BoundaryPoint> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t r = 0; r < polygons.rings.size(); ++r) {
    std::uint32_t index = 0;
    for (const auto [from, to] : polygons.view(polygons.rings[r]).edges()) {
      const Eigen::Vector2d point = nearestOnSegment(p, from, to);
      const double squared = (point - p).squaredNorm();
      if (squared < least) {
        least = squared;
        nearest = BoundaryPoint{point, 0.0, r, index};
      }
      ++index;
    }
  }
  if (nearest) nearest->distance = std::sqrt(least);
  return nearest;
}

double distanceToBoundary(const Eigen::Vector2d& p, const RingView& ring)
{
  double least = std::numeric_limits<double>::infinity();
  for (const auto [from, to] : ring.edges())
    least = std::min(least, (nearestOnSegment(p, from, to) - p).squaredNorm());
  return std::sqrt(least);
}

double distanceToBoundary(const Eigen::Vector2d& p, const PolygonSet& polygons)
{
  double least = std::numeric_limits<double>::infinity();
  for (const PolygonSet::Ring& ring : polygons.rings)
    least = std::min(least, distanceToBoundary(p, polygons.view(ring)));
  return least;
}

}  // namespace polygonal_perception::geometry
