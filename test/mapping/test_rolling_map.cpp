#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "polygonal_perception/mapping/rolling_map.hpp"

namespace polygonal_perception::mapping {

namespace {

/// A sensor whose grid of 20 x 20 cells of 10 cm lies where it is put.
class Sensor
{
public:
  Sensor()
  {
    geometry_.cells_x = geometry_.cells_y = 20;
    geometry_.resolution = 0.1;
    forget();
  }

  void forget()
  {
    hit_.assign(400, 0);
    free_.assign(400, 0);
    floor_.assign(400, 0);
  }
  /// All the floor is seen, and all heights above it are looked through.
  void seeNothing()
  {
    hit_.assign(400, 0);
    free_.assign(400, 0xFF);
    floor_.assign(400, 1);
  }
  std::uint8_t& hit(int i, int j) { return hit_[static_cast<std::size_t>(20 * j + i)]; }
  std::uint8_t& free(int i, int j) { return free_[static_cast<std::size_t>(20 * j + i)]; }
  std::uint8_t& floor(int i, int j) { return floor_[static_cast<std::size_t>(20 * j + i)]; }
  void put(double x, double y, double yaw) { pose_ = Eigen::Translation2d(x, y) * Eigen::Rotation2Dd(yaw); }
  const Eigen::Isometry2d& pose() const { return pose_; }
  const occupancy::GridGeometry& geometry() const { return geometry_; }

  Observation observation(double stamp = 1.0, bool may_clear = true) const
  {
    return {geometry_, pose_, hit_.data(), free_.data(), floor_.data(), may_clear, stamp};
  }

private:
  occupancy::GridGeometry geometry_;
  Eigen::Isometry2d pose_ = Eigen::Isometry2d::Identity();
  std::vector<std::uint8_t> hit_, free_, floor_;
};

class RollingMapTest : public testing::Test
{
protected:
  RollingMapTest() { restart(); }
  void restart()
  {
    map_ = RollingMap(parameters_);
    map_.reset(0.1);
    map_.moveTo({1.0, 1.0});
  }
  bool isOccupied(double x, double y)
  {
    occupancy::BinaryGrid grid;
    map_.copyOccupied(grid);
    const auto cell = grid.geometry().cellOf(x, y);
    return cell && grid.cells()[*cell] != 0;
  }
  std::size_t occupiedCells()
  {
    occupancy::BinaryGrid grid;
    map_.copyOccupied(grid);
    return grid.count();
  }
  void add(int times = 1, bool may_clear = true)
  {
    for (int k = 0; k < times; ++k) map_.add(sensor_.observation(stamp_ += 0.1, may_clear));
  }

  RollingMap::Parameters parameters_{4.0, 3};
  RollingMap map_{parameters_};
  Sensor sensor_;
  double stamp_ = 0.0;
};

TEST_F(RollingMapTest, OneFrameMakesAnObstacle)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  EXPECT_TRUE(isOccupied(0.55, 0.75));
  EXPECT_EQ(occupiedCells(), 1U) << "the sensor's cells are the map's: no neighbour is touched";
}

TEST_F(RollingMapTest, WhatIsOutOfViewStays)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  sensor_.forget();
  add(100);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
}

TEST_F(RollingMapTest, WhatHasGoneIsGoneAfterSoManyViews)
{
  sensor_.hit(5, 7) = 0x11;
  add();
  sensor_.seeNothing();
  add(2);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
  add();
  EXPECT_FALSE(isOccupied(0.55, 0.75));
}

TEST_F(RollingMapTest, TheFloorAloneClearsNothing)
{
  // The seat of a chair: below it the floor is seen, and it was not looked through at its height.
  sensor_.hit(5, 7) = 0x40;
  add();
  sensor_.seeNothing();
  sensor_.free(5, 7) = 0xBF;
  add(100);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
  sensor_.free(5, 7) = 0x40;
  add(3);
  EXPECT_FALSE(isOccupied(0.55, 0.75));
}

TEST_F(RollingMapTest, LookingThroughAloneClearsNothing)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  sensor_.seeNothing();
  sensor_.floor(5, 7) = 0;
  add(100);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
}

TEST_F(RollingMapTest, HeightsGoOneByOne)
{
  sensor_.hit(5, 7) = 0x41;
  add();
  sensor_.seeNothing();
  sensor_.free(5, 7) = 0x01;
  add(3);
  std::vector<std::uint8_t> heights;
  map_.copyHeights(heights);
  EXPECT_EQ(heights[*map_.geometry().cellOf(0.55, 0.75)], 0x40)
      << "of the table the top stays, whose leg has gone";
}

TEST_F(RollingMapTest, ALegThatIsSeenInEveryThirdFrameStays)
{
  for (int frame = 0; frame < 300; ++frame) {
    sensor_.seeNothing();
    if (frame % 3 == 0) sensor_.hit(5, 7) = 0x02;
    add();
    ASSERT_TRUE(isOccupied(0.55, 0.75)) << "frame " << frame;
  }
}

TEST_F(RollingMapTest, WhatMayNotClearMarksAllTheSame)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  sensor_.seeNothing();
  sensor_.hit(9, 9) = 0x01;
  add(100, false);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
  EXPECT_TRUE(isOccupied(0.95, 0.95));
}

TEST_F(RollingMapTest, AHundredCrossingsLeaveNothing)
{
  for (int crossing = 0; crossing < 100; ++crossing) {
    for (int i = 0; i < 20; ++i) {
      sensor_.seeNothing();
      sensor_.hit(i, 10) = 0xFF;
      add();
    }
  }
  sensor_.seeNothing();
  add(3);
  EXPECT_EQ(occupiedCells(), 0U);
}

TEST_F(RollingMapTest, WhatLeavesTheSquareIsForgotten)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  map_.moveTo({2.5, 1.0});
  EXPECT_TRUE(isOccupied(0.55, 0.75)) << "5 cm inside of the border";
  map_.moveTo({2.8, 1.0});
  map_.moveTo({1.0, 1.0});
  EXPECT_EQ(occupiedCells(), 0U);
}

TEST_F(RollingMapTest, OldObstaclesGoWhereThatIsWanted)
{
  parameters_.remember = 5.0;
  restart();
  sensor_.hit(5, 7) = 0x01;
  add();
  map_.forgetOld(stamp_ + 4.9);
  EXPECT_TRUE(isOccupied(0.55, 0.75));
  map_.forgetOld(stamp_ + 5.1);
  EXPECT_FALSE(isOccupied(0.55, 0.75));
}

TEST_F(RollingMapTest, AnotherSizeKeepsWhatIsInBothSquares)
{
  sensor_.hit(5, 7) = 0x01;
  sensor_.hit(10, 10) = 0x01;
  add();
  parameters_.map_size = 1.0;
  map_.configure(parameters_);
  EXPECT_EQ(map_.geometry().cells_x, 10);
  EXPECT_TRUE(isOccupied(1.05, 1.05));
  EXPECT_EQ(occupiedCells(), 2U) << "half a metre from the middle";
  parameters_.map_size = 0.5;
  map_.configure(parameters_);
  EXPECT_TRUE(isOccupied(1.05, 1.05));
  EXPECT_EQ(occupiedCells(), 1U);
}

TEST_F(RollingMapTest, PlacesWithoutANumberAndTinyCellsAreSurvived)
{
  sensor_.seeNothing();
  sensor_.hit(5, 7) = 0x01;
  for (const double place : {1e300, -1e300, 4e9, 1e6}) {
    sensor_.put(place, -place, 0.5);
    add();
    map_.moveTo({place, place});
  }
  map_.reset(1e-9);
  EXPECT_EQ(map_.geometry().cells_x, static_cast<int>(RollingMap::kMostCells));
}

TEST_F(RollingMapTest, AGridWithoutCellsIsNotReadWhereverItLies)
{
  sensor_.hit(5, 7) = 0x01;
  add();
  occupancy::GridGeometry none;
  none.resolution = 0.1;
  const int longest = std::numeric_limits<int>::max();
  for (const auto& [columns, rows] :
       {std::pair(20, 0), std::pair(0, 20), std::pair(0, longest), std::pair(longest, 0)}) {
    none.cells_x = columns;
    none.cells_y = rows;
    for (int yaw = 0; yaw < 8; ++yaw) {
      // Its corner lies on the middle of a cell.
      const Eigen::Isometry2d pose = Eigen::Translation2d(1.05, 1.05) * Eigen::Rotation2Dd(M_PI / 4.0 * yaw);
      map_.add({none, pose, nullptr, nullptr, nullptr, true, stamp_ += 0.1});
    }
  }
  EXPECT_EQ(occupiedCells(), 1U);
}

TEST_F(RollingMapTest, AGridThatIsHardlyTurnedIsNotReadBeyondItsEnd)
{
  // The middles of a row of the map lie just below the upper border of the grid, and leave it on their way: by a step a cell
  // that is so small that it is nothing at first sight.
  occupancy::GridGeometry grid;
  grid.cells_x = grid.cells_y = 20;
  grid.resolution = 0.1;
  const Eigen::Isometry2d pose = Eigen::Translation2d(-0.5, 1.05 - 2.0 + 1.5e-7) * Eigen::Rotation2Dd(-9e-7);
  const std::vector<std::uint8_t> nothing(400 + 20, 0);
  std::vector<std::uint8_t> floor = nothing;
  std::fill(floor.begin() + 400, floor.end(), 1);  // behind its end
  map_.add({grid, pose, nothing.data(), nothing.data(), floor.data(), true, 1.0});
  std::vector<std::uint8_t> seen;
  map_.copySeen(seen);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 0);
}

TEST_F(RollingMapTest, WhatWasSavedComesBack)
{
  std::mt19937 random(5);
  sensor_.seeNothing();
  for (int k = 0; k < 60; ++k)
    sensor_.hit(static_cast<int>(random() % 20), static_cast<int>(random() % 20)) = 0x55;
  add();
  std::vector<std::uint8_t> heights, seen;
  map_.copyHeights(heights);
  map_.copySeen(seen);
  RollingMap other(parameters_);
  other.restore(map_.geometry(), heights, seen, 0.0);
  std::vector<std::uint8_t> heights_again, seen_again;
  other.copyHeights(heights_again);
  other.copySeen(seen_again);
  EXPECT_EQ(other.geometry(), map_.geometry());
  EXPECT_EQ(heights_again, heights);
  EXPECT_EQ(seen_again, seen);
}

TEST_F(RollingMapTest, EveryPointOfAHitIsCoveredWhereverTheGridLies)
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    restart();
    sensor_.forget();
    sensor_.put(number(random), number(random), 6.3 * number(random));
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < 20; ++k) {
      const int i = static_cast<int>(random() % 20);
      const int j = static_cast<int>(random() % 20);
      sensor_.hit(i, j) = 0x01;
      for (int p = 0; p < 20; ++p)
        points.emplace_back(sensor_.pose() *
                            Eigen::Vector2d(0.1 * (i + number(random)), 0.1 * (j + number(random))));
    }
    add();
    const auto bounds = map_.geometry().bounds();
    for (const Eigen::Vector2d& point : points) {
      if (bounds.contains(point)) {
        ASSERT_TRUE(isOccupied(point.x(), point.y())) << "trial " << trial << ": " << point.transpose();
      }
    }
    // A square of 10 cm reaches into at most nine of them.
    ASSERT_LE(occupiedCells(), 20U * 9U);
  }
}

TEST_F(RollingMapTest, RollingChangesNothingOfWhatStays)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int trial = 0; trial < 300; ++trial) {
    restart();
    sensor_.forget();
    for (int k = 0; k < 40; ++k)
      sensor_.hit(static_cast<int>(random() % 20), static_cast<int>(random() % 20)) = 0x01;
    add();
    occupancy::BinaryGrid before;
    map_.copyOccupied(before);
    map_.moveTo({1.0 + 3.0 * number(random), 1.0 + 3.0 * number(random)});
    occupancy::BinaryGrid after;
    map_.copyOccupied(after);
    std::size_t kept = 0;
    for (int j = 0; j < before.cellsY(); ++j) {
      for (int i = 0; i < before.cellsX(); ++i) {
        const double x = before.geometry().origin_x + 0.1 * (i + 0.5);
        const double y = before.geometry().origin_y + 0.1 * (j + 0.5);
        const auto cell = after.geometry().cellOf(x, y);
        if (!cell) continue;
        ASSERT_EQ(after.cells()[*cell] != 0, before.occupied(i, j)) << "trial " << trial;
        kept += before.occupied(i, j) ? 1 : 0;
      }
    }
    ASSERT_EQ(after.count(), kept) << "nothing comes in with what enters";
  }
}

}  // namespace

}  // namespace polygonal_perception::mapping
