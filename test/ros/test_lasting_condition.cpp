#include <gtest/gtest.h>

#include "polygonal_perception/ros/common/lasting_condition.hpp"

namespace polygonal_perception::ros_common {
namespace {

TEST(LastingCondition, IsSaidOnceWhenItHasLasted)
{
  LastingCondition condition(ros::Duration(2.0));
  EXPECT_FALSE(condition.update(true, ros::Time(10.0)));
  EXPECT_FALSE(condition.update(true, ros::Time(11.9)));
  EXPECT_TRUE(condition.update(true, ros::Time(12.1)));
  EXPECT_FALSE(condition.update(true, ros::Time(20.0)));
}

TEST(LastingCondition, BeginsAnewWhenItHasEnded)
{
  LastingCondition condition(ros::Duration(2.0));
  condition.update(true, ros::Time(10.0));
  EXPECT_FALSE(condition.update(false, ros::Time(11.0)));
  EXPECT_FALSE(condition.update(true, ros::Time(12.5)));
  EXPECT_TRUE(condition.update(true, ros::Time(14.6)));
  condition.update(false, ros::Time(15.0));
  condition.update(true, ros::Time(16.0));
  EXPECT_TRUE(condition.update(true, ros::Time(18.0))) << "it has come back";
}

TEST(LastingCondition, APauseIsNoTimeOfIt)
{
  LastingCondition condition(ros::Duration(2.0));
  condition.update(true, ros::Time(10.0));
  condition.reset();
  EXPECT_FALSE(condition.update(true, ros::Time(60.0)));
}

TEST(LastingCondition, StampsMayBeAtBothEndsOfTheirRange)
{
  LastingCondition condition(ros::Duration(2.0));
  condition.update(true, ros::TIME_MIN);
  EXPECT_TRUE(condition.update(true, ros::TIME_MAX));
  condition.reset();
  condition.update(true, ros::TIME_MAX);
  EXPECT_FALSE(condition.update(true, ros::TIME_MIN));
}

}  // namespace
}  // namespace polygonal_perception::ros_common
