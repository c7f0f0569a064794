#include <gtest/gtest.h>

#include "ros/perception/floor_frame_guard.hpp"

namespace polygonal_perception::ros_perception {
namespace {

using std::chrono::milliseconds;

class FloorFrameGuardTest : public testing::Test
{
protected:
  static tf2_msgs::TFMessage floorBelow(const std::string& parent, const std::string& child = "floor")
  {
    tf2_msgs::TFMessage message;
    message.transforms.resize(2);
    message.transforms[0].child_frame_id = "base_link";
    message.transforms[0].header.frame_id = "odom";
    message.transforms[1].child_frame_id = child;
    message.transforms[1].header.frame_id = parent;
    return message;
  }
  void see(FloorFrameGuard& guard, const std::string& parent)
  {
    guard.see(floorBelow(parent), "/other", false, now_);
  }

  FloorFrameGuard guard_{"floor"};
  FloorFrameGuard::Clock::time_point now_;
};

TEST_F(FloorFrameGuardTest, NobodyElseIsNoConflict)
{
  guard_.see(floorBelow("camera", "other_floor"), "/other", false, now_);
  EXPECT_EQ(guard_.conflict("camera", now_), "");
  guard_.broadcast("camera");
  see(guard_, "camera");
  EXPECT_EQ(guard_.conflict("camera", now_), "") << "its own transforms come back to it";
}

TEST_F(FloorFrameGuardTest, WhoComesLaterIsSilentAndSaysWhoWasThere)
{
  see(guard_, "zz_camera");
  const std::string conflict = guard_.conflict("camera", now_);
  EXPECT_NE(conflict.find("'floor' is already broadcast below 'zz_camera', by /other"), std::string::npos)
      << conflict;
  EXPECT_NE(guard_.conflict("camera", now_ + milliseconds(1900)), "");
  EXPECT_EQ(guard_.conflict("camera", now_ + milliseconds(2100)), "") << "the other has ended";
}

TEST_F(FloorFrameGuardTest, OfTwoThatBeganAtOnceOneIsSilent)
{
  FloorFrameGuard other("floor");
  guard_.broadcast("left");
  other.broadcast("right");
  see(guard_, "right");
  see(other, "left");
  EXPECT_EQ(guard_.conflict("left", now_), "");
  EXPECT_NE(other.conflict("right", now_), "");
  see(other, "left");
  EXPECT_NE(other.conflict("right", now_), "") << "and stays so";
}

TEST_F(FloorFrameGuardTest, WhatOneSentBeforeOneWasSilentIsNotSomebodyElses)
{
  guard_.broadcast("right");
  see(guard_, "left");
  EXPECT_NE(guard_.conflict("right", now_), "");
  see(guard_, "right");
  EXPECT_NE(guard_.conflict("right", now_), "") << "its own transform has come back late";
}

TEST_F(FloorFrameGuardTest, AStaticTransformHoldsToTheEndAndBeforeAnyName)
{
  guard_.broadcast("a_camera");
  guard_.see(floorBelow("map"), "/robot_state_publisher", true, now_);
  EXPECT_NE(guard_.conflict("a_camera", now_ + std::chrono::hours(1)), "");
}

TEST_F(FloorFrameGuardTest, ADriverThatTurnsToAnotherFrameIsNoOtherCamera)
{
  guard_.broadcast("b_optical");
  guard_.broadcast("z_body");
  see(guard_, "b_optical");
  EXPECT_EQ(guard_.conflict("z_body", now_), "");
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
