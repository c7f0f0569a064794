#include <gtest/gtest.h>

#include "polygonal_perception/occupancy/grid/binary_grid.hpp"

namespace polygonal_perception::occupancy {
namespace {

TEST(GridGeometry, DefaultsAreThePapers)
{
  const GridGeometry geometry{GridParameters{}};
  EXPECT_EQ(geometry.cells_x, 100);
  EXPECT_EQ(geometry.cells_y, 100);
  EXPECT_DOUBLE_EQ(geometry.origin_x, 0.0);
  EXPECT_DOUBLE_EQ(geometry.origin_y, -2.5);
}

TEST(GridGeometry, WholeCellsAreNotRoundedUp)
{
  // 0.3 / 0.1 is a little less than 3, 0.7 / 0.1 a little more or less than 7.
  const GridGeometry geometry{GridParameters{0.3, 0.7, 0.1}};
  EXPECT_EQ(geometry.cells_x, 3);
  EXPECT_EQ(geometry.cells_y, 7);
}

TEST(GridGeometry, APartOfACellTakesAWholeOne)
{
  const GridGeometry geometry{GridParameters{1.01, 1.0, 0.25}};
  EXPECT_EQ(geometry.cells_x, 5);
  EXPECT_DOUBLE_EQ(geometry.origin_y, -0.5);
}

TEST(GridGeometry, WhatIsBehindTheSensorIsAddedInWholeCells)
{
  const GridGeometry geometry{GridParameters{1.0, 1.0, 0.25, 0.6}};
  EXPECT_EQ(geometry.cells_x, 7);
  EXPECT_DOUBLE_EQ(geometry.origin_x, -0.75);
  EXPECT_TRUE(geometry.bounds().isApprox(
      Eigen::AlignedBox2d(Eigen::Vector2d(-0.75, -0.5), Eigen::Vector2d(1.0, 0.5))));
}

TEST(BinaryGrid, RowsRunAlongX)
{
  BinaryGrid grid{GridGeometry{GridParameters{0.3, 0.2, 0.1}}};
  grid.set(2, 1);
  EXPECT_TRUE(grid.occupied(2, 1));
  EXPECT_EQ(grid.cells(), (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(grid.count(), 1U);
  grid.reset(grid.geometry());
  EXPECT_EQ(grid.count(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::occupancy
