#pragma once

#include <cstddef>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::reference {

/// How many vertices plain Douglas-Peucker leaves of the contours through the centres of a grid's cells:
/// what clause 5 of the polygon contract compares with.
/// @param tolerance  [cells]
/// @param least      a contour counts as so many vertices at least; Douglas-Peucker leaves one of a small one
std::size_t verticesOfDouglasPeucker(const occupancy::BinaryGrid& cells, double tolerance,
                                     std::size_t least = 0);

}  // namespace polygonal_perception::reference
