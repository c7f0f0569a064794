#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "ros/perception/camera_attitude.hpp"
#include "ros/perception/floor_transforms.hpp"

namespace polygonal_perception::ros_perception {
namespace {

/// From an optical frame to the body frame that belongs to it (x ahead, y left, z up).
Eigen::Matrix3d bodyFromOptical()
{
  Eigen::Matrix3d rotation;
  rotation << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return rotation;
}

/// A camera at x, y, z in the world, turned by yaw, pitch (down) and roll.
Eigen::Isometry3d camera(double x, double y, double z, double yaw, double pitch, double roll)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
          .toRotationMatrix() *
      bodyFromOptical();
  pose.translation() << x, y, z;
  return pose;
}

/// What the detector would find of a floor at z = 0.
Eigen::Isometry3d toFloor(const Eigen::Isometry3d& camera)
{
  return perception::floorFrame({camera.linear().row(2).transpose(), camera.translation().z()},
                                perception::ViewAxes{});
}

TEST(OutputPose, IsThePlaceUnderTheCameraAndItsHeading)
{
  const Eigen::Isometry3d pose = camera(3.0, -2.0, 1.2, 0.7, 0.5, -0.1);
  const Eigen::Isometry2d output = poseInOutputFrame(pose, toFloor(pose));
  EXPECT_TRUE(output.translation().isApprox(Eigen::Vector2d(3.0, -2.0), 1e-12))
      << output.translation().transpose();
  EXPECT_NEAR(Eigen::Rotation2Dd(output.linear()).angle(), 0.7, 1e-12);
}

TEST(OutputPose, BringsPointsToWhereTfHasThem)
{
  const Eigen::Isometry3d pose = camera(1.0, 2.0, 0.8, -2.4, 0.3, 0.2);
  const Eigen::Isometry3d to_floor = toFloor(pose);
  const Eigen::Isometry2d output = poseInOutputFrame(pose, to_floor);
  const Eigen::Vector3d point(0.4, 0.1, 2.0);
  const Eigen::Vector3d expected = pose * point;
  const Eigen::Vector3d on_floor = to_floor * point;
  EXPECT_TRUE((output * Eigen::Vector2d(on_floor.head<2>())).isApprox(expected.head<2>(), 1e-9));
  EXPECT_NEAR(on_floor.z(), expected.z(), 1e-9);
}

TEST(OutputPose, KeepsThePlaceWhereTfKnowsNothingOfThePitch)
{
  // A robot's model may have its camera level while it nods: place and heading are still right.
  const Eigen::Isometry3d truth = camera(3.0, -2.0, 1.2, 0.7, 0.4, 0.0);
  const Eigen::Isometry3d from_tf = camera(3.0, -2.0, 1.1, 0.7, 0.0, 0.0);
  const Eigen::Isometry2d output = poseInOutputFrame(from_tf, toFloor(truth));
  EXPECT_TRUE(output.translation().isApprox(Eigen::Vector2d(3.0, -2.0), 1e-12))
      << output.translation().transpose();
  EXPECT_NEAR(Eigen::Rotation2Dd(output.linear()).angle(), 0.7, 1e-12);
}

TEST(FloorTransform, IsTheFloorFrameInTheInputFrame)
{
  std_msgs::Header input;
  input.stamp = ros::Time(5, 6);
  input.frame_id = "camera";
  const Eigen::Isometry3d to_floor = toFloor(camera(0.0, 0.0, 1.2, 0.0, 0.5, 0.1));
  const geometry_msgs::TransformStamped message = toTransform(input, "floor", to_floor);
  EXPECT_EQ(message.header.frame_id, "camera");
  EXPECT_EQ(message.child_frame_id, "floor");
  EXPECT_EQ(message.header.stamp, input.stamp);
  const auto& t = message.transform.translation;
  const auto& q = message.transform.rotation;
  const Eigen::Isometry3d floor_to_input =
      Eigen::Translation3d(t.x, t.y, t.z) * Eigen::Quaterniond(q.w, q.x, q.y, q.z);
  EXPECT_TRUE((to_floor * floor_to_input).isApprox(Eigen::Isometry3d::Identity(), 1e-12));
}

TEST(CameraAttitude, PitchIsDownAndRollIsLeftSideUp)
{
  for (const double pitch : {-0.3, 0.0, 0.7}) {
    for (const double roll : {-0.2, 0.0, 0.3}) {
      const Eigen::Isometry3d pose = camera(0.0, 0.0, 1.0, 1.1, pitch, roll);
      const ros_perception::CameraAttitude attitude = cameraAttitude(
          pose.linear().row(2).transpose(), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY());
      EXPECT_NEAR(attitude.pitch, pitch, 1e-12);
      EXPECT_NEAR(attitude.roll, roll, 1e-12);
    }
  }
}

}  // namespace
}  // namespace polygonal_perception::ros_perception
