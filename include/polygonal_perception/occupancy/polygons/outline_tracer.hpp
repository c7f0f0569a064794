#pragma once

#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// Finds the outlines of a grid's cells.
class POLYGONAL_PERCEPTION_EXPORT OutlineTracer
{
public:
  /// @param outlines  filled anew
  void trace(const BitGrid& cells, Outlines& outlines);

private:
  struct Line;

  void sweepLine(const Line& line, Outlines& outlines);
  void addCorner(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines);
  void addCrossing(const Line& line, int x, std::uint32_t surroundings, Outlines& outlines);
  std::uint32_t addVertex(LatticePoint at, Outlines& outlines);
  void closeBelow(std::uint32_t vertex, int x, bool solid_before, Outlines& outlines);
  void closeBefore(std::uint32_t vertex, bool solid_above, Outlines& outlines) const;
  std::uint32_t outlineBefore(const Line& line, int x) const;
  void collectRings(Outlines& outlines);

  std::vector<std::uint64_t> outside_;     ///< a free row: what lies below the first row and above the last
  std::vector<std::uint32_t> open_below_;  ///< a column's vertex whose upper edge is being followed
  std::uint32_t open_before_ = 0;          ///< the line's vertex whose edge along x is being followed
  /// Of a vertex where a ring may start: a vertex of the outline next to it along -x.
  std::vector<std::uint32_t> before_;
  std::vector<std::uint32_t> ring_of_;  ///< the ring of a vertex
};

}  // namespace polygonal_perception::occupancy
