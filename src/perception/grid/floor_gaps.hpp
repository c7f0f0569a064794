#pragma once

#include <cstdint>
#include <vector>

#include "perception/grid/cell_scanner.hpp"
#include "polygonal_perception/perception/grid/binary_grid.hpp"

namespace polygonal_perception::perception {

/// Closes the gaps between the rows in which a far floor is seen: a few metres away the rows of an image lie farther apart
/// on the floor than cells, which would make a comb of it.
///
/// Two pixels that are neighbours in a column and both see the floor have nothing between them: neither an edge nor a
/// shadow, in which pixels see something else or nothing.
class FloorGaps
{
public:
  /// Forgets the last frame.
  void begin(const GridGeometry& geometry);

  /// Marks the cells between those of a row of the image and those of the row before.
  /// @param row    its cells; those of the floor are in layer 0
  /// @param floor  the marks of that layer
  void fill(const CellScanner::Row& row, std::uint8_t* floor);

private:
  void fillBlock(const CellBlock& here, const CellBlock& before, std::uint8_t* floor) const;
  bool isFloor(std::uint32_t cell) const { return cell - 1 < size_; }
  /// How far apart two cells lie, by the longer side.
  int distance(std::uint32_t a, std::uint32_t b) const;

  std::uint32_t size_ = 0;
  int columns_ = 1;
  std::vector<CellBlock> before_;
};

}  // namespace polygonal_perception::perception
