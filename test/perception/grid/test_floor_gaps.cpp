#include <gtest/gtest.h>

#include <vector>

#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/projection_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const occupancy::GridGeometry kGrid{occupancy::GridParameters{}};

test::PackedPoint floorAt(float x, float y = 0.02F)
{
  return {x, y, 0.0F, 0.0F};
}

/// What is observed of a frame a pixel wide: a column of the image.
occupancy::ObservedCells observe(const std::vector<test::PackedPoint>& column, std::uint32_t width = 1)
{
  occupancy::ObservedCells observed;
  occupancy::BinaryGrid occupancy{kGrid};
  Projection(Projection::Parameters{})
      .project(PointView::points(column.data(), width, static_cast<std::uint32_t>(column.size()) / width),
               Eigen::Isometry3d::Identity(), occupancy, {}, {&observed});
  return observed;
}

/// The columns of the grid in which the floor is seen, in the row of y = 0.02.
std::vector<int> seenColumns(const occupancy::ObservedCells& observed)
{
  std::vector<int> columns;
  for (int i = 0; i < kGrid.cells_x; ++i) {
    if (observed.floor[static_cast<std::size_t>(50 * kGrid.cells_x + i)] != 0) columns.push_back(i);
  }
  return columns;
}

TEST(FloorGaps, TwoNeighboursInAColumnOfTheImageHaveFloorBetweenThem)
{
  EXPECT_EQ(seenColumns(observe({floorAt(4.02F), floorAt(3.87F)})), (std::vector<int>{77, 78, 79, 80}));
}

TEST(FloorGaps, AGapOfMoreThanTwoCellsStays)
{
  EXPECT_EQ(seenColumns(observe({floorAt(4.02F), floorAt(3.82F)})), (std::vector<int>{76, 80}));
}

TEST(FloorGaps, WhatStandsBetweenThemKeepsItsShadow)
{
  EXPECT_EQ(seenColumns(observe({floorAt(4.02F), {3.8F, 0.02F, 0.1F, 0.0F}, floorAt(3.87F)})),
            (std::vector<int>{77, 80}));
}

TEST(FloorGaps, WhereThereIsNoReturnNothingWasSeen)
{
  EXPECT_EQ(seenColumns(observe({floorAt(4.02F), {kNaN, kNaN, kNaN, 0.0F}, floorAt(3.87F)})),
            (std::vector<int>{77, 80}));
}

TEST(FloorGaps, NeighboursInARowAreNotJoined)
{
  EXPECT_EQ(seenColumns(observe({floorAt(4.02F), floorAt(3.87F)}, 2)), (std::vector<int>{77, 80}));
}

TEST(FloorGaps, AcrossTheGridTheCellsOnTheWayAreMarked)
{
  // From cell (80, 50) to cell (77, 52); listed row by row.
  const occupancy::ObservedCells observed = observe({floorAt(4.02F, 0.02F), floorAt(3.87F, 0.12F)});
  std::vector<std::pair<int, int>> seen;
  for (int j = 0; j < kGrid.cells_y; ++j) {
    for (int i = 0; i < kGrid.cells_x; ++i) {
      if (observed.floor[static_cast<std::size_t>(j * kGrid.cells_x + i)] != 0) seen.emplace_back(i, j);
    }
  }
  EXPECT_EQ(seen, (std::vector<std::pair<int, int>>{{80, 50}, {78, 51}, {79, 51}, {77, 52}}));
}

}  // namespace
}  // namespace polygonal_perception::perception
