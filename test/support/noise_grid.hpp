#pragma once

#include <random>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::test {

/// A grid of which each cell is occupied with a probability, whatever its neighbours are. Cells of 1 m.
inline occupancy::BinaryGrid noiseGrid(int cells_x, int cells_y, double density, std::mt19937& random)
{
  occupancy::GridGeometry geometry;
  geometry.cells_x = cells_x;
  geometry.cells_y = cells_y;
  geometry.resolution = 1.0;
  occupancy::BinaryGrid grid(geometry);
  std::bernoulli_distribution occupied(density);
  for (int j = 0; j < cells_y; ++j) {
    for (int i = 0; i < cells_x; ++i) grid.set(i, j, occupied(random));
  }
  return grid;
}

}  // namespace polygonal_perception::test
