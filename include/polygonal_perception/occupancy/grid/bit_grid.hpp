#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::occupancy {

/// A binary grid with 64 cells to a word, so that one instruction treats 64 cells. Bit i % 64 of word i / 64
/// of row j is cell (i, j). A row has at least one spare bit behind its last cell, which is always 0: the
/// free space that borders the grid.
class POLYGONAL_PERCEPTION_EXPORT BitGrid
{
public:
  static constexpr int kWordBits = 64;
  static constexpr int kSpareBits = 16;

  /// Takes on a size and frees every cell. Allocates only when the grid grows.
  void reset(int cells_x, int cells_y);
  /// Takes on the size and the cells of a grid.
  void pack(const BinaryGrid& cells);
  /// Writes the cells into a grid, which takes on the geometry given; it must have this grid's size.
  void unpack(const GridGeometry& geometry, BinaryGrid& cells) const;

  /// Takes on the size of another grid and its cells, grown by a shape that is symmetrical: `half_widths[d]`
  /// cells to either side in the rows d above and below a cell, none wider than the one before it.
  void grow(const BitGrid& cells, const std::vector<int>& half_widths);

  int cellsX() const { return cells_x_; }
  int cellsY() const { return cells_y_; }
  std::size_t wordsPerRow() const { return words_per_row_; }

  const std::uint64_t* row(int j) const
  {
    return words_.data() + static_cast<std::size_t>(j) * words_per_row_;
  }
  std::uint64_t* row(int j) { return words_.data() + static_cast<std::size_t>(j) * words_per_row_; }

  bool test(int i, int j) const { return (row(j)[i / kWordBits] >> (i % kWordBits) & 1U) != 0; }

  /// To be called after a row was shifted beyond its last cell.
  void clearSpareBits();

private:
  void addShifted(int shift);

  int cells_x_ = 0;
  int cells_y_ = 0;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> shifted_;  ///< work space
};

}  // namespace polygonal_perception::occupancy
