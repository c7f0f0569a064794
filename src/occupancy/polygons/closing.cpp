#include "occupancy/polygons/closing.hpp"

#include <algorithm>

namespace polygonal_perception::occupancy {

namespace {

constexpr int kMaxShift = BitGrid::kWordBits - 1;

/// Calls step(shift) so often that runs of one cell become runs of width + 1.
template <class Step>
void inDoublingSteps(int width, int max_shift, const Step& step)
{
  int run = 1;
  for (int left = width; left > 0;) {
    const int shift = std::min({left, run, max_shift});
    step(shift);
    left -= shift;
    run += shift;
  }
}

}  // namespace

void Closing::close(int width, BitGrid& cells)
{
  if (width <= 0) return;
  grown_.reset(cells.cellsX() + width, cells.cellsY() + width);
  const std::size_t words = grown_.wordsPerRow();
  const int rows = grown_.cellsY();

  // Each cell grows by `width` cells up and along x, ...
  for (int j = 0; j < cells.cellsY(); ++j) {
    std::uint64_t* row = grown_.row(j);
    std::copy_n(cells.row(j), cells.wordsPerRow(), row);
    inDoublingSteps(width, kMaxShift, [&](int shift) {
      for (std::size_t w = words; w-- > 0;) {
        row[w] |= row[w] << shift | (w > 0 ? row[w - 1] >> (BitGrid::kWordBits - shift) : 0);
      }
    });
  }
  inDoublingSteps(width, rows, [&](int shift) {
    for (int j = rows; j-- > shift;) {
      for (std::size_t w = 0; w < words; ++w) grown_.row(j)[w] |= grown_.row(j - shift)[w];
    }
  });
  // ... and what is grown shrinks back from there.
  inDoublingSteps(width, rows, [&](int shift) {
    for (int j = 0; j < rows; ++j) {
      for (std::size_t w = 0; w < words; ++w)
        grown_.row(j)[w] &= j + shift < rows ? grown_.row(j + shift)[w] : 0;
    }
  });
  for (int j = 0; j < cells.cellsY(); ++j) {
    std::uint64_t* row = grown_.row(j);
    inDoublingSteps(width, kMaxShift, [&](int shift) {
      for (std::size_t w = 0; w < words; ++w) {
        row[w] &= row[w] >> shift | (w + 1 < words ? row[w + 1] << (BitGrid::kWordBits - shift) : 0);
      }
    });
    std::copy_n(row, cells.wordsPerRow(), cells.row(j));
  }
  cells.clearSpareBits();
}

}  // namespace polygonal_perception::occupancy
