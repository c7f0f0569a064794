#include "geometry/ring_nesting.hpp"

#include <map>

#include "geometry/invalidity.hpp"
#include "geometry/ring_sweep.hpp"

namespace polygonal_perception::geometry {

namespace {

/// The rings around the one that is looked at, and what they say about it.
class Enclosure
{
public:
  explicit Enclosure(const PolygonSet& polygons)
      : polygons_(polygons),
        boundary_of_(polygons.rings.size()),
        holes_(polygons.rings.size(), 0),
        depth_(polygons.rings.size(), 0)
  {
    for (std::uint32_t r = 0; r < polygons.rings.size(); ++r)
      boundary_of_[r] = polygons.rings[r].hole ? boundary_of_[r - 1] : r;
  }

  void enter(std::uint32_t ring)
  {
    const std::uint32_t boundary = boundary_of_[ring];
    if (polygons_.rings[ring].hole) {
      if (holes_[boundary]++ == 0 && depth_[boundary] > 0) covering_.erase(depth_[boundary]);
    } else {
      depth_[ring] = ++entered_;
      if (holes_[ring] == 0) covering_[depth_[ring]] = ring;
    }
  }

  void leave(std::uint32_t ring)
  {
    const std::uint32_t boundary = boundary_of_[ring];
    if (polygons_.rings[ring].hole) {
      if (--holes_[boundary] == 0 && depth_[boundary] > 0) covering_[depth_[boundary]] = boundary;
    } else {
      covering_.erase(depth_[ring]);
      depth_[ring] = 0;
      --entered_;
    }
  }

  /// What is wrong with a ring that lies in all that were entered.
  std::optional<Invalidity> faultOf(std::uint32_t ring) const
  {
    const Eigen::Vector2d& vertex = polygons_.vertices[polygons_.rings[ring].first];
    const std::uint32_t boundary = boundary_of_[ring];
    if (!polygons_.rings[ring].hole) {
      if (covering_.empty()) return std::nullopt;
      return invalidity(Defect::kPolygonsOverlap, ring, vertex,
                        "lies inside of the polygon of ring " + std::to_string(covering_.rbegin()->second));
    }
    if (depth_[boundary] == 0)
      return invalidity(Defect::kHoleOutside, ring, vertex, "is a hole outside of its boundary");
    if (holes_[boundary] > 0) return invalidity(Defect::kHoleOutside, ring, vertex, "is a hole in a hole");
    return std::nullopt;
  }

private:
  const PolygonSet& polygons_;
  std::vector<std::uint32_t> boundary_of_;  // of each ring's polygon
  // Of each boundary: how many of its polygon's holes were entered, and how many boundaries with it; 0: it was not.
  std::vector<std::uint32_t> holes_;
  std::vector<std::uint32_t> depth_;
  std::uint32_t entered_ = 0;
  std::map<std::uint32_t, std::uint32_t> covering_;  // by depth: boundaries without any of their holes
};

}  // namespace

std::optional<Invalidity> findWrongNesting(const PolygonSet& polygons,
                                           const std::vector<std::uint32_t>& around)
{
  const auto count = static_cast<std::uint32_t>(polygons.rings.size());
  if (count == 0) return std::nullopt;
  if (polygons.rings[0].hole) {
    return invalidity(Defect::kHoleOutside, 0, polygons.vertices[polygons.rings[0].first],
                      "is a hole without a boundary");
  }
  // The rings right inside of each one, and of none, as lists.
  std::vector<std::uint32_t> inside(count + 1, RingSweep::kNone);
  std::vector<std::uint32_t> beside(count, RingSweep::kNone);
  for (std::uint32_t r = 0; r < count; ++r) {
    std::uint32_t& first = inside[around[r] == RingSweep::kNone ? count : around[r]];
    beside[r] = first;
    first = r;
  }
  // From the outside in and back: rings may lie in one another deeper than calls may.
  std::optional<Invalidity> found;  // the one with the least ring
  Enclosure enclosure(polygons);
  std::vector<std::uint32_t> entered;
  std::uint32_t next = inside[count];
  while (next != RingSweep::kNone || !entered.empty()) {
    if (next == RingSweep::kNone) {
      enclosure.leave(entered.back());
      next = beside[entered.back()];
      entered.pop_back();
      continue;
    }
    if (!found || next < found->ring) {
      if (auto fault = enclosure.faultOf(next)) found = std::move(fault);
    }
    enclosure.enter(next);
    entered.push_back(next);
    next = inside[next];
  }
  return found;
}

}  // namespace polygonal_perception::geometry
