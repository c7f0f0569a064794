#include "polygonal_perception/geometry/validity.hpp"

#include "geometry/invalidity.hpp"
#include "geometry/ring_contacts.hpp"
#include "geometry/ring_nesting.hpp"
#include "geometry/ring_sweep.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

namespace {

std::optional<Invalidity> findBadVertex(const RingView& ring, std::size_t r)
{
  if (ring.size() < 3) {
    return invalidity(Defect::kTooFewVertices, r, ring.empty() ? Eigen::Vector2d::Zero() : ring[0],
                      "has only " + std::to_string(ring.size()) + " vertices");
  }
  for (const Eigen::Vector2d& vertex : ring) {
    if (!vertex.allFinite()) return invalidity(Defect::kNotFinite, r, vertex, "is not finite");
  }
  for (const auto [from, to] : ring.edges()) {
    if (from == to) return invalidity(Defect::kRepeatedVertex, r, from, "repeats a vertex");
  }
  return std::nullopt;
}

std::optional<Invalidity> findWrongOrientation(const PolygonSet& polygons)
{
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    const RingView ring = polygons.view(polygons.rings[r]);
    const bool hole = polygons.rings[r].hole;
    if ((orientation(ring) == Orientation::kClockwise) == hole) continue;
    return invalidity(Defect::kWrongOrientation, r, ring[0],
                      hole ? "is a hole and runs counter-clockwise" : "is a boundary and runs clockwise");
  }
  return std::nullopt;
}

}  // namespace

std::optional<Invalidity> findDefect(const PolygonSet& polygons)
{
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    if (auto found = findBadVertex(polygons.view(polygons.rings[r]), r)) return found;
  }
  RingSweep sweep(polygons);
  if (auto found = findContact(polygons, sweep)) return found;
  if (auto found = findWrongOrientation(polygons)) return found;
  return findWrongNesting(polygons, sweep.around());
}

}  // namespace polygonal_perception::geometry
