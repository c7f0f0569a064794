#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "grid_from_text.hpp"
#include "polygonal_perception/inflation.hpp"

namespace polygonal_perception {
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
  return textFromGrid(result);
}

TEST(Inflation, RadiusZeroLeavesTheGridAsItIs)
{
  const std::vector<std::string> cells = {"#..#", ".#..", "...#"};
  EXPECT_EQ(inflated(gridFromText(cells), 0.0), cells);
}

TEST(Inflation, SmallestRadiusTakesTheCellsThatTouch)
{
  EXPECT_EQ(inflated(gridFromText({".....", ".....", "..#..", ".....", "....."}), 1e-3),
            (std::vector<std::string>{".....", ".###.", ".###.", ".###.", "....."}));
}

TEST(Inflation, RadiusOfWholeCellsTakesJustThose)
{
  EXPECT_EQ(
      inflated(gridFromText({".......", ".......", ".......", "...#...", ".......", ".......", "......."}),
               2.0),
      (std::vector<std::string>{".......", ".#####.", ".#####.", ".#####.", ".#####.", ".#####.",
                                "......."}));
}

TEST(Inflation, KeepsWhatReachesOverTheBorder)
{
  EXPECT_EQ(inflated(gridFromText({"#..", "...", "..."}), 1.2),
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

TEST(Inflation, AgreesWithTheGapOfEveryPairOfCells)
{
  std::mt19937 random(4);
  for (const int cells_x : {1, 7, 63, 64, 65, 130}) {
    for (const double radius : {0.0, 0.4, 1.0, 2.2, 4.5, 6.0, 70.0}) {
      GridGeometry geometry;
      geometry.cells_x = cells_x;
      geometry.cells_y = 20;
      geometry.resolution = 1.0;
      BinaryGrid grid(geometry);
      for (int n = 0; n < 6; ++n)
        grid.set(static_cast<int>(random() % cells_x), static_cast<int>(random() % 20));
      BinaryGrid result;
      inflationBy(radius).inflate(grid, result);

      BinaryGrid expected(geometry);
      for (int j = 0; j < 20; ++j) {
        for (int i = 0; i < cells_x; ++i) {
          for (int l = 0; l < 20; ++l) {
            for (int k = 0; k < cells_x; ++k) {
              if (!grid.occupied(k, l)) continue;
              const double gap =
                  std::hypot(std::max(0, std::abs(i - k) - 1), std::max(0, std::abs(j - l) - 1));
              if (gap < radius || (i == k && j == l)) expected.set(i, j);
            }
          }
        }
      }
      EXPECT_EQ(textFromGrid(result), textFromGrid(expected))
          << "radius " << radius << ", " << cells_x << " columns";
    }
  }
}

}  // namespace
}  // namespace polygonal_perception
