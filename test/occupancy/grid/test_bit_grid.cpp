#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "polygonal_perception/occupancy/grid/bit_grid.hpp"
#include "support/bits_from_text.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

/// Rows of a width that just fits its words, or just does not.
class BitGridOfWidth : public testing::TestWithParam<int>
{
protected:
  std::mt19937 random_{20201024};
};

TEST_P(BitGridOfWidth, HasRoomToShiftARowBeyondItsEnd)
{
  BitGrid bits;
  bits.reset(GetParam(), 2);
  EXPECT_GE(static_cast<int>(bits.wordsPerRow()) * BitGrid::kWordBits, GetParam() + BitGrid::kSpareBits);
}

TEST_P(BitGridOfWidth, PacksEveryCellToItsBit)
{
  for (const double density : {0.0, 0.3, 1.0}) {
    const BinaryGrid grid = test::noiseGrid(GetParam(), 5, density, random_);
    const BitGrid bits = test::bitsOf(grid);
    EXPECT_EQ(test::textFromBits(bits), test::textFromGrid(grid));
    EXPECT_FALSE(test::hasStrayBits(bits));
  }
}

TEST_P(BitGridOfWidth, UnpacksWhatWasPacked)
{
  const BinaryGrid grid = test::noiseGrid(GetParam(), 5, 0.4, random_);
  GridGeometry geometry = grid.geometry();
  geometry.resolution = 0.25;
  BinaryGrid unpacked;
  test::bitsOf(grid).unpack(geometry, unpacked);
  EXPECT_EQ(test::textFromGrid(unpacked), test::textFromGrid(grid));
  EXPECT_EQ(unpacked.geometry(), geometry);
}

TEST_P(BitGridOfWidth, ResetFreesEveryCell)
{
  BitGrid bits = test::bitsOf(test::noiseGrid(GetParam(), 5, 1.0, random_));
  bits.reset(GetParam(), 3);
  EXPECT_EQ(test::textFromBits(bits),
            std::vector<std::string>(3, std::string(static_cast<std::size_t>(GetParam()), '.')));
}

TEST_P(BitGridOfWidth, ClearsTheSpareBitsAndNoCell)
{
  BitGrid bits;
  bits.reset(GetParam(), 4);
  for (int j = 0; j < 4; ++j) std::fill_n(bits.row(j), bits.wordsPerRow(), ~std::uint64_t{0});
  bits.clearSpareBits();
  EXPECT_EQ(test::textFromBits(bits),
            std::vector<std::string>(4, std::string(static_cast<std::size_t>(GetParam()), '#')));
  EXPECT_FALSE(test::hasStrayBits(bits));
}

/// Grows cell by cell.
BinaryGrid grown(const BinaryGrid& grid, const std::vector<int>& half_widths)
{
  BinaryGrid result(grid.geometry());
  const int reach = static_cast<int>(half_widths.size()) - 1;
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int l = std::max(0, j - reach); l <= std::min(grid.cellsY() - 1, j + reach); ++l) {
      const int half_width = half_widths[static_cast<std::size_t>(std::abs(l - j))];
      for (int i = 0; i < grid.cellsX(); ++i) {
        const int last = std::min(grid.cellsX() - 1, i + half_width);
        for (int k = std::max(0, i - half_width); grid.occupied(i, j) && k <= last; ++k) result.set(k, l);
      }
    }
  }
  return result;
}

TEST_P(BitGridOfWidth, GrowsAsALoopOverTheCellsDoes)
{
  const auto upTo = [this](int largest) { return std::uniform_int_distribution<>(0, largest)(random_); };
  for (int trial = 0; trial < 200; ++trial) {
    const BinaryGrid grid = test::noiseGrid(GetParam(), 1 + upTo(8), trial % 2 == 0 ? 0.01 : 0.1, random_);
    std::vector<int> half_widths(static_cast<std::size_t>(1 + upTo(10)));
    for (int& half_width : half_widths) half_width = upTo(trial % 5 == 0 ? 150 : 20);
    std::sort(half_widths.rbegin(), half_widths.rend());
    BitGrid bits;
    bits.grow(test::bitsOf(grid), half_widths);
    ASSERT_EQ(test::textFromBits(bits), test::textFromGrid(grown(grid, half_widths)))
        << "half widths " << testing::PrintToString(half_widths) << " around "
        << testing::PrintToString(test::textFromGrid(grid));
    ASSERT_FALSE(test::hasStrayBits(bits));
  }
}

// 48 cells are the most that leave the spare bits in the first word.
INSTANTIATE_TEST_SUITE_P(Cells, BitGridOfWidth, testing::Values(1, 8, 47, 48, 49, 63, 64, 65, 112, 113, 128),
                         testing::PrintToStringParamName());

TEST(BitGrid, GrowsByNothingWithoutAShape)
{
  BitGrid bits;
  bits.grow(test::bitsFromText({"#.", ".#"}), {});
  EXPECT_EQ(test::textFromBits(bits), (std::vector<std::string>{"..", ".."}));
}

TEST(BitGrid, WhatGrowsOverTheBorderStaysInItsRow)
{
  BitGrid bits;
  bits.grow(test::bitsFromText({"....", "...#", "#..."}), {2});
  EXPECT_EQ(test::textFromBits(bits), (std::vector<std::string>{"....", ".###", "###."}));
}

}  // namespace
}  // namespace polygonal_perception::occupancy
