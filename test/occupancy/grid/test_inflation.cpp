#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "polygonal_perception/occupancy/grid/inflation.hpp"
#include "support/grid_from_text.hpp"

namespace polygonal_perception::occupancy {
namespace {

Inflation inflationBy(double robot_radius)
{
  Inflation::Parameters parameters;
  parameters.robot_radius = robot_radius;
  return Inflation(parameters);
}

std::vector<std::string> inflated(const BinaryGrid& grid, double robot_radius)
{
  BinaryGrid result;
  inflationBy(robot_radius).inflate(grid, result);
  return test::textFromGrid(result);
}

TEST(Inflation, RadiusZeroLeavesTheGridAsItIs)
{
  const std::vector<std::string> cells = {"#..#", ".#..", "...#"};
  EXPECT_EQ(inflated(test::gridFromText(cells), 0.0), cells);
}

TEST(Inflation, SmallestRadiusTakesTheCellsThatTouch)
{
  EXPECT_EQ(inflated(test::gridFromText({".....", ".....", "..#..", ".....", "....."}), 1e-3),
            (std::vector<std::string>{".....", ".###.", ".###.", ".###.", "....."}));
}

TEST(Inflation, RadiusOfWholeCellsTakesJustThose)
{
  EXPECT_EQ(inflated(test::gridFromText(
                         {".......", ".......", ".......", "...#...", ".......", ".......", "......."}),
                     2.0),
            (std::vector<std::string>{".......", ".#####.", ".#####.", ".#####.", ".#####.", ".#####.",
                                      "......."}));
}

TEST(Inflation, KeepsWhatReachesOverTheBorder)
{
  EXPECT_EQ(inflated(test::gridFromText({"#..", "...", "..."}), 1.2),
            (std::vector<std::string>{"###", "###", "##."}));
}

TEST(Inflation, SixCellsAreSixCellsThoughTheQuotientIsNot)
{
  GridGeometry geometry{GridParameters{}};
  BinaryGrid grid(geometry);
  grid.set(50, 50);
  BinaryGrid result;
  inflationBy(0.30).inflate(grid, result);
  EXPECT_TRUE(result.occupied(56, 50));
  EXPECT_FALSE(result.occupied(57, 50));
  EXPECT_EQ(result.count(), 157U);
}

bool isWithin(double radius, const BinaryGrid& grid, int i, int j)
{
  for (int l = 0; l < grid.cellsY(); ++l) {
    for (int k = 0; k < grid.cellsX(); ++k) {
      if (!grid.occupied(k, l)) continue;
      const double gap = std::hypot(std::max(0, std::abs(i - k) - 1), std::max(0, std::abs(j - l) - 1));
      if (gap < radius || (i == k && j == l)) return true;
    }
  }
  return false;
}

TEST(Inflation, AgreesWithTheGapOfEveryPairOfCells)
{
  std::mt19937 random(4);
  const auto upTo = [&random](int largest) {
    return static_cast<int>(random() % static_cast<unsigned>(largest)) + 1;
  };
  for (int trial = 0; trial < 1000; ++trial) {
    GridGeometry geometry;
    geometry.cells_x = upTo(140);
    geometry.cells_y = upTo(20);
    geometry.resolution = 1.0;
    BinaryGrid grid(geometry);
    for (int n = upTo(4); n > 0; --n) grid.set(upTo(geometry.cells_x) - 1, upTo(geometry.cells_y) - 1);
    const double radius = trial % 50 == 0 ? 70.0 : 0.1 * (upTo(90) - 1);
    BinaryGrid result;
    inflationBy(radius).inflate(grid, result);

    BinaryGrid expected(geometry);
    for (int j = 0; j < geometry.cells_y; ++j) {
      for (int i = 0; i < geometry.cells_x; ++i) expected.set(i, j, isWithin(radius, grid, i, j));
    }
    ASSERT_EQ(test::textFromGrid(result), test::textFromGrid(expected))
        << "radius " << radius << " around " << ::testing::PrintToString(test::textFromGrid(grid));
  }
}

}  // namespace
}  // namespace polygonal_perception::occupancy
