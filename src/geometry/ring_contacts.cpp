#include "geometry/ring_contacts.hpp"

#include "geometry/invalidity.hpp"
#include "polygonal_perception/geometry/measures.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

namespace {

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

Invalidity invalidityOf(const RingSweep::Contact& contact)
{
  const Eigen::Vector2d place = meetingPoint(contact.first.edge, contact.second.edge);
  const std::uint32_t ring = contact.first.ring;
  const std::uint32_t other = contact.second.ring;
  if (ring == other) return invalidity(Defect::kRingMeetsItself, ring, place, "crosses or touches itself");
  return invalidity(Defect::kRingsMeet, ring, place, "meets ring " + std::to_string(other));
}

}  // namespace

std::optional<Invalidity> findContact(const PolygonSet& polygons, RingSweep& sweep)
{
  const auto contact = sweep.run();
  if (!contact) return std::nullopt;
  const Invalidity found = invalidityOf(*contact);
  if (found.defect == Defect::kRingMeetsItself) return found;
  // Of a ring that meets itself the others may have hidden it.
  for (std::size_t r = 0; r < polygons.rings.size(); ++r) {
    RingSweep alone(polygons, r);
    if (const auto of_one = alone.run()) return invalidityOf(*of_one);
  }
  return found;
}

}  // namespace polygonal_perception::geometry
