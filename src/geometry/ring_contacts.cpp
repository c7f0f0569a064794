#include "geometry/ring_contacts.hpp"

#include <algorithm>
#include <vector>

#include "geometry/invalidity.hpp"
#include "geometry/overlapping_boxes.hpp"
#include "polygonal_perception/geometry/measures.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

namespace {

/// An edge, and where it is from.
struct PlacedEdge
{
  Edge edge;
  std::size_t ring;
  std::size_t index;
};

/// A point that two segments share.
Eigen::Vector2d meetingPoint(const Edge& a, const Edge& b)
{
  for (const Eigen::Vector2d& end : {b.from, b.to}) {
    if (isOnSegment(end, a.from, a.to)) return end;
  }
  for (const Eigen::Vector2d& end : {a.from, a.to}) {
    if (isOnSegment(end, b.from, b.to)) return end;
  }
  const Eigen::Vector2d along = a.to - a.from;
  const Eigen::Vector2d other = b.to - b.from;
  return a.from + cross(b.from - a.from, other) / cross(along, other) * along;
}

/// Edges meet where they have a point in common, but for the vertex of two that follow one another.
bool meet(const PolygonSet& polygons, const PlacedEdge& a, const PlacedEdge& b)
{
  const SegmentContact contact = segmentContact(a.edge.from, a.edge.to, b.edge.from, b.edge.to);
  if (a.ring == b.ring) {
    const RingView ring = polygons.view(polygons.rings[a.ring]);
    if (ring.next(a.index) == b.index || ring.next(b.index) == a.index)
      return contact == SegmentContact::kOverlap;
  }
  return contact != SegmentContact::kNone;
}

}  // namespace

std::optional<Invalidity> findContact(const PolygonSet& polygons)
{
  std::vector<PlacedEdge> edges;
  std::vector<Eigen::AlignedBox2d> boxes;
  edges.reserve(polygons.vertices.size());
  boxes.reserve(polygons.vertices.size());
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    const RingView ring = polygons.view(polygons.rings[r]);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      edges.push_back({ring.edge(k), r, k});
      boxes.emplace_back(ring.edge(k).from.cwiseMin(ring.edge(k).to),
                         ring.edge(k).from.cwiseMax(ring.edge(k).to));
    }
  }
  std::optional<Invalidity> found;
  anyOverlappingPair(boxes, [&](std::uint32_t i, std::uint32_t j) {
    const PlacedEdge& a = edges[std::min(i, j)];
    const PlacedEdge& b = edges[std::max(i, j)];
    const bool of_one_ring = a.ring == b.ring;
    if ((found && !of_one_ring) || !meet(polygons, a, b)) return false;
    const Eigen::Vector2d place = meetingPoint(a.edge, b.edge);
    found = of_one_ring
                ? invalidity(Defect::kRingMeetsItself, a.ring, place, "crosses or touches itself")
                : invalidity(Defect::kRingsMeet, a.ring, place, "meets ring " + std::to_string(b.ring));
    return of_one_ring;
  });
  return found;
}

}  // namespace polygonal_perception::geometry
