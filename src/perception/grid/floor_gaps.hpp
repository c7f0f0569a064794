#pragma once

#include <cstdint>
#include <vector>

#include "perception/grid/cell_scanner.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

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
  void begin(const occupancy::GridGeometry& geometry);

  /// Marks the cells between those of a row of the image and those of the row before, if that was given, too.
  /// @param v      which row it is
  /// @param row    its cells; those of the floor are in layer 0
  /// @param floor  the marks of that layer
  void fill(std::uint32_t v, const CellScanner::Row& row, std::uint8_t* floor);

  /// How many of the next rows would show the floor in the same cells: near the camera ten rows and more lie in a cell.
  std::uint32_t rowsAlike() const { return rows_alike_; }

private:
  void fillBlock(const CellBlock& here, const CellBlock& before, std::uint8_t* floor);
  bool isFloor(std::uint32_t cell) const { return cell - 1 < size_; }
  /// How far apart two cells lie, by the longer side.
  int distance(std::uint32_t a, std::uint32_t b) const;

  std::uint32_t size_ = 0;
  int columns_ = 1;
  std::vector<CellBlock> before_;
  std::uint32_t row_before_ = 0;
  std::uint32_t rows_alike_ = 0;
  float cells_per_row_ = 1.0F;  // how far the floor's rows are apart
  std::uint32_t compared_ = 0;  // pixels of the row that see the floor in this row and in the one before,
  std::uint32_t moved_ = 0;     // and of them those that see it in another cell
};

}  // namespace polygonal_perception::perception
