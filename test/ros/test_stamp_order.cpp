#include <gtest/gtest.h>

#include "polygonal_perception/ros/common/stamp_order.hpp"

namespace polygonal_perception::ros_common {
namespace {

/// Whether it means that time has jumped back; taken in any case.
bool come(StampOrder& order, double stamp)
{
  const bool jumps = order.jumpsBack(ros::Time(stamp));
  order.take(ros::Time(stamp));
  return jumps;
}

TEST(StampOrder, WhatIsALittleOutOfOrderIsNoJump)
{
  StampOrder order;
  for (const double stamp : {10.0, 10.1, 9.5, 9.6, 10.2}) EXPECT_FALSE(come(order, stamp)) << stamp;
  EXPECT_EQ(order.newest(), ros::Time(10.2));
}

TEST(StampOrder, TwoOldOnesInARowAreOne)
{
  StampOrder order;
  EXPECT_FALSE(come(order, 10.0));
  EXPECT_FALSE(come(order, 5.0));
  EXPECT_FALSE(come(order, 5.0)) << "the same message, which waits";
  EXPECT_TRUE(come(order, 5.1));
}

TEST(StampOrder, OneOldOneBetweenNewOnesIsNone)
{
  StampOrder order;
  for (const double stamp : {10.0, 5.0, 10.1, 5.1, 10.2}) EXPECT_FALSE(come(order, stamp)) << stamp;
}

TEST(StampOrder, AnyStampsAreCompared)
{
  EXPECT_TRUE(isOlder(ros::TIME_MIN, ros::TIME_MAX, 1.0));
  EXPECT_FALSE(isOlder(ros::TIME_MAX, ros::TIME_MIN, 1.0));
  EXPECT_FALSE(isOlder(ros::TIME_MAX, ros::TIME_MAX, 0.0));
}

}  // namespace
}  // namespace polygonal_perception::ros_common
