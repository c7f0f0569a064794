#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "occupancy/polygons/closing.hpp"
#include "support/bits_from_text.hpp"
#include "support/noise_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

using Text = std::vector<std::string>;

Text closed(int width, const Text& cells)
{
  BitGrid bits = test::bitsFromText(cells);
  Closing().close(width, bits);
  return test::textFromBits(bits);
}

TEST(Closing, FillsAGapOfItsWidthAndNoWiderOne)
{
  const Text gap = {"##..##", "##..##", "##..##"};
  EXPECT_EQ(closed(1, gap), gap);
  EXPECT_EQ(closed(2, gap), (Text{"######", "######", "######"}));
}

TEST(Closing, LeavesTheCellsAsTheyAreWithoutAWidth)
{
  const Text gap = {"#.#", ".#."};
  EXPECT_EQ(closed(0, gap), gap);
  EXPECT_EQ(closed(-1, gap), gap);
}

TEST(Closing, FillsHolesThatAreNarrowOneWay)
{
  EXPECT_EQ(closed(1, {"######", "#....#", "######"}), (Text{"######", "######", "######"}));
  const Text room = {"####", "#..#", "#..#", "####"};
  EXPECT_EQ(closed(1, room), room);
}

TEST(Closing, SpaceOutsideOfTheGridIsFree)
{
  EXPECT_EQ(closed(5, {"..", ".."}), (Text{"..", ".."}));
  // In the grid's corner there is room for any square, beyond it.
  const Text nook = {"##", ".#"};
  EXPECT_EQ(closed(5, nook), nook);
}

TEST(Closing, ACloserMayBeUsedForGridsOfAnySize)
{
  Closing closing;
  BitGrid large = test::bitsFromText(Text(4, std::string(70, '#')));
  closing.close(3, large);
  BitGrid small = test::bitsFromText({"#..#"});
  closing.close(1, small);
  EXPECT_EQ(test::textFromBits(small), (Text{"#..#"}));
}

bool isFreeSquare(const BinaryGrid& grid, int first_i, int first_j, int side)
{
  for (int j = std::max(0, first_j); j < std::min(grid.cellsY(), first_j + side); ++j) {
    for (int i = std::max(0, first_i); i < std::min(grid.cellsX(), first_i + side); ++i) {
      if (grid.occupied(i, j)) return false;
    }
  }
  return true;
}

/// By what it is meant to be: a cell stays free that belongs to a free square.
BinaryGrid plainlyClosed(int width, const BinaryGrid& grid)
{
  BinaryGrid result(grid.geometry());
  std::fill_n(result.row(0), grid.geometry().size(), std::uint8_t{1});
  for (int j = -width; j < grid.cellsY(); ++j) {
    for (int i = -width; i < grid.cellsX(); ++i) {
      if (!isFreeSquare(grid, i, j, width + 1)) continue;
      for (int l = std::max(0, j); l <= std::min(grid.cellsY() - 1, j + width); ++l) {
        for (int k = std::max(0, i); k <= std::min(grid.cellsX() - 1, i + width); ++k)
          result.set(k, l, false);
      }
    }
  }
  return result;
}

TEST(Closing, LeavesFreeWhatBelongsToAFreeSquare)
{
  std::mt19937 random(20201024);
  const auto between = [&random](int low, int high) {
    return std::uniform_int_distribution<>(low, high)(random);
  };
  for (int trial = 0; trial < 400; ++trial) {
    // Some closings are wider than a word, where a shift has to be done in steps.
    const int width = trial % 20 == 0 ? between(60, 80) : between(1, 6);
    const double density = trial % 20 == 0 ? 0.01 : 0.1;
    const BinaryGrid grid = test::noiseGrid(between(1, 140), between(1, 12), density, random);
    BitGrid bits = test::bitsOf(grid);
    Closing().close(width, bits);
    ASSERT_EQ(test::textFromBits(bits), test::textFromGrid(plainlyClosed(width, grid)))
        << "width " << width << ", of " << testing::PrintToString(test::textFromGrid(grid));
    ASSERT_FALSE(test::hasStrayBits(bits));
  }
}

double distanceToCells(const BinaryGrid& grid, double x, double y)
{
  double least = HUGE_VAL;
  for (int j = 0; j < grid.cellsY(); ++j) {
    for (int i = 0; i < grid.cellsX(); ++i) {
      if (!grid.occupied(i, j)) continue;
      least =
          std::min(least, std::hypot(std::max({0.0, i - x, x - i - 1}), std::max({0.0, j - y, y - j - 1})));
    }
  }
  return least;
}

TEST(Closing, FillsNothingThatIsFarFromTheCells)
{
  std::mt19937 random(5);
  int filled = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int width = 1 + trial % 5;
    const BinaryGrid grid = test::noiseGrid(20, 12, 0.15, random);
    BitGrid bits = test::bitsOf(grid);
    Closing().close(width, bits);
    for (int k = 0; k < 20 * 12; ++k) {
      if (!bits.test(k % 20, k / 20) || grid.occupied(k % 20, k / 20)) continue;
      ++filled;
      for (const double offset : {0.0, 0.5, 1.0}) {
        for (const double other : {0.0, 0.5, 1.0}) {
          ASSERT_LE(distanceToCells(grid, k % 20 + offset, k / 20 + other), width * std::sqrt(0.5) + 1e-9)
              << "cell (" << k % 20 << ", " << k / 20 << "), width " << width << ", of "
              << testing::PrintToString(test::textFromGrid(grid));
        }
      }
    }
  }
  EXPECT_GT(filled, 1000) << "too few cells to tell anything";
}

}  // namespace
}  // namespace polygonal_perception::occupancy
