#include "polygonal_perception/geometry/measures.hpp"

namespace polygonal_perception::geometry {

double signedArea(const RingView& ring)
{
  // About the first vertex: far from the origin the products would cancel.
  double twice = 0.0;
  for (const auto [from, to] : ring.edges()) twice += cross(from - ring[0], to - ring[0]);
  return 0.5 * twice;
}

double area(const PolygonSet& polygons)
{
  double sum = 0.0;
  for (const PolygonSet::Ring& ring : polygons.rings) sum += signedArea(polygons.view(ring));
  return sum;
}

Eigen::AlignedBox2d bounds(const RingView& ring)
{
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& vertex : ring) box.extend(vertex);
  return box;
}

Eigen::AlignedBox2d bounds(const PolygonSet& polygons)
{
  return bounds(RingView(polygons.vertices));
}

PolygonSet transformed(const PolygonSet& polygons, const Eigen::Isometry2d& pose)
{
  PolygonSet moved = polygons;
  for (Eigen::Vector2d& vertex : moved.vertices) vertex = pose * vertex;
  return moved;
}

}  // namespace polygonal_perception::geometry
