#include "occupancy/polygons/staircase_bridging.hpp"

#include <algorithm>
#include <cstdlib>

namespace polygonal_perception::occupancy {

namespace {

constexpr std::int32_t kLongestSide = 2 * kUnitsPerCell;

/// The number of the cell that begins at a lattice coordinate (of a corner that is a corner of cells), or
/// that ends there.
int cellNextTo(std::int32_t coordinate, bool behind)
{
  return coordinate / kUnitsPerCell - (behind ? 0 : 1);
}

/// Are the cells of the block free? Cells outside of the grid are.
bool isFree(const BitGrid& cells, int first_i, int last_i, int first_j, int last_j)
{
  first_i = std::max(first_i, 0);
  last_i = std::min(last_i, cells.cellsX() - 1);
  last_j = std::min(last_j, cells.cellsY() - 1);
  for (int j = std::max(first_j, 0); j <= last_j; ++j) {
    for (int i = first_i; i <= last_i; ++i) {
      if (cells.test(i, j)) return false;
    }
  }
  return true;
}

}  // namespace

/// With a side of one cell the triangle covers nothing but free cells next to the sides' own cells. If the
/// cells behind the triangle are free too, no other outline is near, and no other bridge either: that would
/// have to start from a cell next to it.
bool StaircaseBridging::isBridgeable(const BitGrid& cells, Proximity& proximity, const Outlines& outlines,
                                     std::uint32_t vertex) const
{
  const Outlines::Vertex& corner = outlines.vertices[vertex];
  const LatticePoint a = outlines.vertices[corner.previous].at;
  const LatticePoint b = corner.at;
  const LatticePoint c = outlines.vertices[corner.next].at;
  const bool square = (a.x == b.x && b.y == c.y) || (a.y == b.y && b.x == c.x);
  const bool parted = b.x % kUnitsPerCell != 0 || b.y % kUnitsPerCell != 0;
  if (cross(a, b, c) >= 0 || !square || parted) return false;
  // The free quadrant, seen from b, is the one in which a and c lie.
  const std::int32_t side_x = a.x + c.x - 2 * b.x;
  const std::int32_t side_y = a.y + c.y - 2 * b.y;
  const std::int32_t shorter = std::min(std::abs(side_x), std::abs(side_y));
  const std::int32_t longer = std::max(std::abs(side_x), std::abs(side_y));
  if (shorter != kUnitsPerCell || longer > kLongestSide || longer % kUnitsPerCell != 0) return false;
  const int near_i = cellNextTo(b.x, side_x > 0);
  const int near_j = cellNextTo(b.y, side_y > 0);
  const int far_i = cellNextTo(b.x + side_x, side_x > 0);
  const int far_j = cellNextTo(b.y + side_y, side_y > 0);
  return isFree(cells, std::min(near_i, far_i), std::max(near_i, far_i), std::min(near_j, far_j),
                std::max(near_j, far_j)) &&
         proximity.covers(a, b, c);
}

void StaircaseBridging::bridge(const BitGrid& cells, Proximity& proximity, Outlines& outlines)
{
  std::vector<Outlines::Vertex>& vertices = outlines.vertices;
  bridged_.resize(vertices.size());
  // All are judged before any is cut off, as the cells know nothing of bridges.
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    bridged_[v] = isBridgeable(cells, proximity, outlines, v) ? 1 : 0;
  for (Outlines::Ring& ring : outlines.rings) {
    while (bridged_[ring.start] != 0) ring.start = vertices[ring.start].next;
    std::uint32_t v = ring.start;
    for (std::uint32_t n = ring.size; n > 0; --n) {
      const std::uint32_t next = vertices[v].next;
      if (bridged_[v] != 0) outlines.remove(v, ring);
      v = next;
    }
  }
}

}  // namespace polygonal_perception::occupancy
