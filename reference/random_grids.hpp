#pragma once

#include <random>
#include <string>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::reference {

/// A grid of one of the kinds that polygons go wrong on: noise of every density, blobs, lines, spirals,
/// checkerboards, nested rings, full, empty, single cells, shapes along the border.
/// @param kind  any number; kinds repeat
occupancy::BinaryGrid randomGrid(unsigned kind, int cells_x, int cells_y, double resolution,
                                 std::mt19937& random);

/// The grid as lines of '#' and '.', the last row first, so that it looks as from above.
std::string toText(const occupancy::BinaryGrid& grid);

}  // namespace polygonal_perception::reference
