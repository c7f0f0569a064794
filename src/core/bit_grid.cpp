#include "bit_grid.hpp"

#include <cstring>

namespace polygonal_perception {

namespace {

constexpr int kBytesPerLoad = 8;

/// Gathers 8 bytes of 0 or 1 into 8 bits: byte k, times the power 2^(56 - 7k) of the factor, lands in bit 56
/// + k. Little-endian, as are all platforms of ROS 1.
std::uint64_t gatherBits(const std::uint8_t* bytes)
{
  std::uint64_t eight = 0;
  std::memcpy(&eight, bytes, sizeof eight);
  return (eight * 0x0102040810204080ULL) >> 56;
}

/// Spreads 8 bits into 8 bytes of 0 or 1: the product holds the bits eight times, the mask keeps bit k in
/// byte k, and the sum carries it into the byte's top bit.
void scatterBits(std::uint64_t bits, std::uint8_t* bytes)
{
  const std::uint64_t bit_in_each = (bits * 0x0101010101010101ULL) & 0x8040201008040201ULL;
  const std::uint64_t eight = (bit_in_each + 0x7F7F7F7F7F7F7F7FULL) >> 7 & 0x0101010101010101ULL;
  std::memcpy(bytes, &eight, sizeof eight);
}

}  // namespace

void BitGrid::reset(int cells_x, int cells_y)
{
  cells_x_ = cells_x;
  cells_y_ = cells_y;
  words_per_row_ = static_cast<std::size_t>(cells_x) / kWordBits + 1;
  words_.assign(words_per_row_ * static_cast<std::size_t>(cells_y), 0);
}

void BitGrid::pack(const BinaryGrid& cells)
{
  reset(cells.cellsX(), cells.cellsY());
  for (int j = 0; j < cells_y_; ++j) {
    const std::uint8_t* from = cells.row(j);
    std::uint64_t* to = row(j);
    int i = 0;
    for (; i + kBytesPerLoad <= cells_x_; i += kBytesPerLoad) {
      to[i / kWordBits] |= gatherBits(from + i) << (i % kWordBits);
    }
    for (; i < cells_x_; ++i) to[i / kWordBits] |= static_cast<std::uint64_t>(from[i]) << (i % kWordBits);
  }
}

void BitGrid::unpack(const GridGeometry& geometry, BinaryGrid& cells) const
{
  cells.reset(geometry);
  for (int j = 0; j < cells_y_; ++j) {
    const std::uint64_t* from = row(j);
    std::uint8_t* to = cells.row(j);
    int i = 0;
    for (; i + kBytesPerLoad <= cells_x_; i += kBytesPerLoad) {
      scatterBits(from[i / kWordBits] >> (i % kWordBits) & 0xFFU, to + i);
    }
    for (; i < cells_x_; ++i) to[i] = test(i, j) ? 1 : 0;
  }
}

}  // namespace polygonal_perception
