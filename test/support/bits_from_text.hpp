#pragma once

#include <string>
#include <vector>

#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "support/grid_from_text.hpp"

namespace polygonal_perception::test {

inline occupancy::BitGrid bitsOf(const occupancy::BinaryGrid& grid)
{
  occupancy::BitGrid bits;
  bits.pack(grid);
  return bits;
}

/// A bit grid as it is drawn, the topmost row first.
inline occupancy::BitGrid bitsFromText(const std::vector<std::string>& lines)
{
  return bitsOf(gridFromText(lines));
}

/// Reads bit by bit, so that a test of pack() and unpack() leans on neither.
inline std::vector<std::string> textFromBits(const occupancy::BitGrid& bits)
{
  std::vector<std::string> lines;
  for (int j = bits.cellsY() - 1; j >= 0; --j) {
    std::string line;
    for (int i = 0; i < bits.cellsX(); ++i) line += bits.test(i, j) ? '#' : '.';
    lines.push_back(line);
  }
  return lines;
}

/// Whether a bit is set that belongs to no cell: rows would run into each other.
inline bool hasStrayBits(const occupancy::BitGrid& bits)
{
  for (int j = 0; j < bits.cellsY(); ++j) {
    const auto end = static_cast<int>(bits.wordsPerRow()) * occupancy::BitGrid::kWordBits;
    for (int i = bits.cellsX(); i < end; ++i) {
      if (bits.test(i, j)) return true;
    }
  }
  return false;
}

}  // namespace polygonal_perception::test
