#include "geometry/ring_nesting.hpp"

#include <algorithm>
#include <vector>

#include "geometry/invalidity.hpp"
#include "geometry/overlapping_boxes.hpp"
#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/measures.hpp"

namespace polygonal_perception::geometry {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

}  // namespace

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
  // The innermost ring around each one, which leads to the others. Rings do not meet, so that the box of one in
  // another lies inside of the other's box. Lists of all around each would need memory for a square of rings.
  std::vector<std::size_t> around(count, kNone);
  const auto note = [&](std::size_t inner, std::size_t outer) {
    if (boxes[outer].min().x() >= boxes[inner].min().x()) return;
    const Eigen::Vector2d& vertex = polygons.view(polygons.rings[inner])[0];
    if (locate(vertex, polygons.view(polygons.rings[outer])) != Location::kInside) return;
    if (around[inner] == kNone || boxes[outer].min().x() > boxes[around[inner]].min().x())
      around[inner] = outer;
  };
  anyOverlappingPair(boxes, [&](std::uint32_t i, std::uint32_t j) {
    note(i, j);
    note(j, i);
    return false;
  });

  std::vector<std::size_t> crossed;  // the boundaries of the holes around a ring
  for (std::size_t r = 0; r < count; ++r) {
    const Eigen::Vector2d& vertex = polygons.view(polygons.rings[r])[0];
    if (polygons.rings[r].hole) {
      bool in_boundary = false;
      bool in_sibling = false;
      for (std::size_t outer = around[r]; outer != kNone; outer = around[outer]) {
        in_boundary = in_boundary || outer == boundary_of[r];
        in_sibling = in_sibling || (polygons.rings[outer].hole && boundary_of[outer] == boundary_of[r]);
      }
      if (!in_boundary)
        return invalidity(Defect::kHoleOutside, r, vertex, "is a hole outside of its boundary");
      if (in_sibling) return invalidity(Defect::kHoleOutside, r, vertex, "is a hole in a hole");
      continue;
    }
    crossed.clear();
    for (std::size_t outer = around[r]; outer != kNone; outer = around[outer]) {
      if (polygons.rings[outer].hole) crossed.push_back(boundary_of[outer]);
    }
    std::sort(crossed.begin(), crossed.end());
    for (std::size_t outer = around[r]; outer != kNone; outer = around[outer]) {
      if (polygons.rings[outer].hole || std::binary_search(crossed.begin(), crossed.end(), outer)) continue;
      return invalidity(Defect::kPolygonsOverlap, r, vertex,
                        "lies inside of the polygon of ring " + std::to_string(outer));
    }
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::geometry
