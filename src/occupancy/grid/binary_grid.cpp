#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

#include <cmath>

namespace polygonal_perception::occupancy {

namespace {

int cellsToCover(double length, double resolution)
{
  // A length of 100.0000001 cells is a rounding error away from 100.
  constexpr double kRounding = 1e-6;
  return std::max(1, static_cast<int>(std::ceil(length / resolution - kRounding)));
}

int cellsBehind(const GridParameters& parameters)
{
  return parameters.grid_behind > 0.0 ? cellsToCover(parameters.grid_behind, parameters.grid_resolution) : 0;
}

}  // namespace

GridGeometry::GridGeometry(const GridParameters& parameters)
    : cells_x(cellsBehind(parameters) + cellsToCover(parameters.grid_length, parameters.grid_resolution)),
      cells_y(cellsToCover(parameters.grid_width, parameters.grid_resolution)),
      resolution(parameters.grid_resolution),
      origin_x(-cellsBehind(parameters) * parameters.grid_resolution),
      origin_y(-0.5 * cells_y * parameters.grid_resolution)
{
}

}  // namespace polygonal_perception::occupancy
