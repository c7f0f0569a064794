#include "polygonal_perception/occupancy/grid/bit_grid.hpp"

#include <algorithm>
#include <cstring>

namespace polygonal_perception::occupancy {

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

/// Packs up to 64 bytes of 0 or 1 into a word.
std::uint64_t packWord(const std::uint8_t* bytes, int count)
{
  std::uint64_t word = 0;
  int n = 0;
  for (; n + kBytesPerLoad <= count; n += kBytesPerLoad) word |= gatherBits(bytes + n) << n;
  for (; n < count; ++n) word |= static_cast<std::uint64_t>(bytes[n]) << n;
  return word;
}

void unpackWord(std::uint64_t word, std::uint8_t* bytes, int count)
{
  int n = 0;
  for (; n + kBytesPerLoad <= count; n += kBytesPerLoad) scatterBits(word >> n & 0xFFU, bytes + n);
  for (; n < count; ++n) bytes[n] = word >> n & 1U;
}

}  // namespace

void BitGrid::reset(int cells_x, int cells_y)
{
  cells_x_ = cells_x;
  cells_y_ = cells_y;
  words_per_row_ = static_cast<std::size_t>(cells_x + kSpareBits - 1) / kWordBits + 1;
  words_.assign(words_per_row_ * static_cast<std::size_t>(cells_y), 0);
}

void BitGrid::pack(const BinaryGrid& cells)
{
  reset(cells.cellsX(), cells.cellsY());
  for (int j = 0; j < cells_y_; ++j) {
    const std::uint8_t* from = cells.row(j);
    std::uint64_t* to = row(j);
    for (int left = cells_x_; left > 0; left -= kWordBits, from += kWordBits) {
      *to++ = left >= kWordBits ? packWord(from, kWordBits) : packWord(from, left);
    }
  }
}

void BitGrid::unpack(const GridGeometry& geometry, BinaryGrid& cells) const
{
  cells.reset(geometry);
  for (int j = 0; j < cells_y_; ++j) {
    const std::uint64_t* from = row(j);
    std::uint8_t* to = cells.row(j);
    for (int left = cells_x_; left > 0; left -= kWordBits, to += kWordBits) {
      left >= kWordBits ? unpackWord(*from++, to, kWordBits) : unpackWord(*from++, to, left);
    }
  }
}

void BitGrid::clearSpareBits()
{
  // The spare bits may begin in the row's last word but one.
  for (std::size_t w = static_cast<std::size_t>(cells_x_) / kWordBits; w < words_per_row_; ++w) {
    const int used = cells_x_ - static_cast<int>(w) * kWordBits;
    const std::uint64_t keep = used > 0 ? (std::uint64_t{1} << used) - 1 : 0;
    for (std::size_t at = w; at < words_.size(); at += words_per_row_) words_[at] &= keep;
  }
}

/// Adds to each cell those `shift` cells before and behind it. The rows are treated as one long string of
/// bits: the spare bits keep them apart.
void BitGrid::addShifted(int shift)
{
  const int back = kWordBits - shift;
  shifted_.resize(words_.size() + 2);
  const std::size_t count = words_.size();
  std::uint64_t* const padded = shifted_.data();
  std::copy_n(words_.data(), count, padded + 1);
  padded[0] = 0;
  padded[count + 1] = 0;
  for (std::size_t w = 0; w < count; ++w) {
    const std::uint64_t word = padded[w + 1];
    words_[w] = word | word << shift | word >> shift | padded[w] >> back | padded[w + 2] << back;
  }
  clearSpareBits();
}

void BitGrid::grow(const BitGrid& cells, const std::vector<int>& half_widths)
{
  reset(cells.cellsX(), cells.cellsY());
  // From the shape's middle outwards: what came in earlier is spread further.
  for (std::size_t d = 0; d < half_widths.size(); ++d) {
    const std::size_t offset = d * words_per_row_;
    if (offset < words_.size()) {
      const std::size_t count = words_.size() - offset;
      for (std::size_t w = 0; w < count; ++w) words_[w] |= cells.words_[w + offset];
      for (std::size_t w = 0; w < count; ++w) words_[w + offset] |= cells.words_[w];
    }
    // A step may be as long as the runs that the steps before it made out of single cells; at the border
    // these have only one side.
    int left = half_widths[d] - (d + 1 < half_widths.size() ? half_widths[d + 1] : 0);
    for (int one_sided_run = 1; left > 0;) {
      const int shift = std::min({left, one_sided_run, kSpareBits});
      addShifted(shift);
      left -= shift;
      one_sided_run += shift;
    }
  }
}

}  // namespace polygonal_perception::occupancy
