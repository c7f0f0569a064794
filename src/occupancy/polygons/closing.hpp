#pragma once

#include "polygonal_perception/occupancy/grid/bit_grid.hpp"

namespace polygonal_perception::occupancy {

/// Fills gaps between cells that are too narrow to matter: a free cell stays free only if it belongs to a
/// free square of width + 1 cells (a morphological closing). No point of a filled cell is farther than
/// `width` x sqrt(1/2) from a cell that was set before. Space outside of the grid is free.
class Closing
{
public:
  void close(int width, BitGrid& cells);

private:
  BitGrid grown_;
};

}  // namespace polygonal_perception::occupancy
