// What the map's intake makes of stamps, of one source and of several.
#include <gtest/gtest.h>

#include "observations.hpp"
#include "ros/mapping/map_intake.hpp"

namespace polygonal_perception::test {
namespace {

class MapIntakeTest : public testing::Test
{
protected:
  /// Takes in cells that see something, or nothing but floor.
  ros_mapping::MapIntake::Admission take(const ros::Time& stamp, std::size_t source = 0,
                                         bool is_clear = false)
  {
    const ObservedCellsPtr cells = observedCells(stamp);
    if (is_clear) cells->hit.assign(cells->hit.size(), 0);
    const auto admission = intake_.admit(source, *cells);
    constexpr double kMaxDelay = 0.3;
    if (admission.fault == nullptr)
      intake_.take(source, *cells, {std::nullopt, Eigen::Isometry3d::Identity()}, kMaxDelay);
    return admission;
  }

  std::size_t occupiedCells()
  {
    mapping::PolygonMap::Products products;
    products.occupied = true;
    return intake_.map().make(products).occupied.count();
  }

  ros_mapping::MapIntake intake_{mapping::PolygonMap::Parameters{}, {"front", "rear"}};
};

TEST_F(MapIntakeTest, WhatIsLateBesideAnotherSourceClearsNothing)
{
  take(ros::Time(10.0));
  take(ros::Time(20.0), 1);
  for (int k = 1; k < 10; ++k) take(ros::Time(10.0 + 0.1 * k), 0, true);
  EXPECT_EQ(occupiedCells(), 1U);
  for (int k = 1; k < 10; ++k) take(ros::Time(19.8 + 0.1 * k), 0, true);
  EXPECT_EQ(occupiedCells(), 0U);
}

TEST_F(MapIntakeTest, TwoOldStampsInARowBeginAnew)
{
  take(ros::Time(10.0));
  EXPECT_FALSE(take(ros::Time(5.0), 0, true).time_jumped_back);
  EXPECT_EQ(occupiedCells(), 1U);
  EXPECT_TRUE(take(ros::Time(5.1), 0, true).time_jumped_back);
  EXPECT_EQ(occupiedCells(), 0U);
}

TEST_F(MapIntakeTest, StampsAtTheEndsOfTheirRangeAreTaken)
{
  for (const ros::Time& stamp : {ros::TIME_MAX, ros::TIME_MIN, ros::TIME_MAX, ros::Time(1.0), ros::Time(2.0)})
    EXPECT_EQ(take(stamp).fault, nullptr) << stamp;
  EXPECT_EQ(take(ros::TIME_MAX, 1).fault, nullptr);
  EXPECT_EQ(occupiedCells(), 1U);
}

}  // namespace
}  // namespace polygonal_perception::test
