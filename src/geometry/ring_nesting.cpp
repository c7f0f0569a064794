#include "geometry/ring_nesting.hpp"

#include <algorithm>
#include <vector>

#include "geometry/invalidity.hpp"
#include "geometry/overlapping_boxes.hpp"
#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/measures.hpp"

namespace polygonal_perception::geometry {

std::optional<Invalidity> findWrongNesting(const PolygonSet& polygons)
{
  const std::size_t count = polygons.rings.size();
  std::vector<Eigen::AlignedBox2d> boxes(count);
  std::vector<std::size_t> boundary_of(count);  // of each ring's polygon
  for (std::size_t r = 0; r < count; ++r) {
    const RingView ring = polygons.view(polygons.rings[r]);
    if (polygons.rings[r].hole && r == 0) {
      return invalidity(Defect::kHoleOutside, r, ring[0], "is a hole without a boundary");
    }
    boxes[r] = bounds(ring);
    boundary_of[r] = polygons.rings[r].hole ? boundary_of[r - 1] : r;
  }
  std::vector<std::vector<std::size_t>> around(count);  // the rings that each one lies in
  const auto note = [&](std::size_t inner, std::size_t outer) {
    const Eigen::Vector2d& vertex = polygons.view(polygons.rings[inner])[0];
    if (locate(vertex, polygons.view(polygons.rings[outer])) == Location::kInside)
      around[inner].push_back(outer);
  };
  anyOverlappingPair(boxes, [&](std::uint32_t i, std::uint32_t j) {
    note(i, j);
    note(j, i);
    return false;
  });

  for (std::size_t r = 0; r < count; ++r) {
    const Eigen::Vector2d& vertex = polygons.view(polygons.rings[r])[0];
    const auto is_in = [&](auto holds) { return std::any_of(around[r].begin(), around[r].end(), holds); };
    if (polygons.rings[r].hole) {
      if (!is_in([&](std::size_t outer) { return outer == boundary_of[r]; })) {
        return invalidity(Defect::kHoleOutside, r, vertex, "is a hole outside of its boundary");
      }
      const auto is_sibling = [&](std::size_t outer) {
        return polygons.rings[outer].hole && boundary_of[outer] == boundary_of[r];
      };
      if (is_in(is_sibling)) return invalidity(Defect::kHoleOutside, r, vertex, "is a hole in a hole");
      continue;
    }
    for (const std::size_t outer : around[r]) {
      const auto is_hole_of_outer = [&](std::size_t other) {
        return polygons.rings[other].hole && boundary_of[other] == outer;
      };
      if (polygons.rings[outer].hole || is_in(is_hole_of_outer)) continue;
      return invalidity(Defect::kPolygonsOverlap, r, vertex,
                        "lies inside of the polygon of ring " + std::to_string(outer));
    }
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::geometry
