#pragma once

#include <cstddef>
#include <cstdint>

#include "occupancy/polygons/outline_reduction.hpp"
#include "occupancy/polygons/proximity.hpp"
#include "polygonal_perception/occupancy/polygons/outlines.hpp"

namespace polygonal_perception::occupancy {

/// Saves vertices of outlines, those first that add the least ground, until the next one would add too much.
/// Where that leaves more vertices than there should be, it goes on with those that add more.
class Simplification
{
public:
  /// @param cells_x,cells_y  size of the grid
  /// @param max_added_area   [cells] for each vertex saved
  /// @param enough           so few vertices are worth no more than that; more of them are
  /// @param proximity        the limit that nothing may go beyond
  void simplify(int cells_x, int cells_y, double max_added_area, std::size_t enough, Proximity& proximity,
                Outlines& outlines);

private:
  void reduce(Outlines::Ring& ring, std::int64_t max_cost, std::size_t enough);

  OutlineReduction reduction_;
  std::size_t vertices_ = 0;  ///< of all rings
};

}  // namespace polygonal_perception::occupancy
