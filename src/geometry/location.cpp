#include "polygonal_perception/geometry/location.hpp"

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

Location locate(const Eigen::Vector2d& p, const RingView& ring)
{
  // How many edges a ray from p along x crosses. A vertex at its height counts as above it, so that an edge
  // is crossed at one of its ends only.
  bool odd = false;
  for (const auto [from, to] : ring.edges()) {
    if (isOnSegment(p, from, to)) return Location::kBoundary;
    const bool up = from.y() < p.y();
    if (up == (to.y() < p.y())) continue;
    const Orientation side = orientation(from, to, p);
    if (side == (up ? Orientation::kCounterClockwise : Orientation::kClockwise)) odd = !odd;
  }
  return odd ? Location::kInside : Location::kOutside;
}

Location locate(const Eigen::Vector2d& p, const PolygonSet& polygons)
{
  bool odd = false;
  for (const PolygonSet::Ring& ring : polygons.rings) {
    const Location location = locate(p, polygons.view(ring));
    if (location == Location::kBoundary) return location;
    odd = odd != (location == Location::kInside);
  }
  return odd ? Location::kInside : Location::kOutside;
}

}  // namespace polygonal_perception::geometry
