#pragma once

#include <string>
#include <vector>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::test {

/// A grid as it is drawn: the first line is the topmost row (greatest y), '#' is an occupied cell. Cells of 1
/// m, the corner of cell (0, 0) in the origin.
inline occupancy::BinaryGrid gridFromText(const std::vector<std::string>& lines)
{
  occupancy::GridGeometry geometry;
  geometry.cells_x = static_cast<int>(lines.front().size());
  geometry.cells_y = static_cast<int>(lines.size());
  geometry.resolution = 1.0;
  occupancy::BinaryGrid grid(geometry);
  for (int j = 0; j < geometry.cells_y; ++j) {
    const std::string& line = lines[lines.size() - 1 - static_cast<std::size_t>(j)];
    for (int i = 0; i < geometry.cells_x; ++i) grid.set(i, j, line[static_cast<std::size_t>(i)] == '#');
  }
  return grid;
}

inline std::vector<std::string> textFromGrid(const occupancy::BinaryGrid& grid)
{
  std::vector<std::string> lines;
  for (int j = grid.cellsY() - 1; j >= 0; --j) {
    std::string line;
    for (int i = 0; i < grid.cellsX(); ++i) line += grid.occupied(i, j) ? '#' : '.';
    lines.push_back(line);
  }
  return lines;
}

}  // namespace polygonal_perception::test
