#include <gtest/gtest.h>

#include "polygonal_perception/perception/floor/floor_frame.hpp"

namespace polygonal_perception::perception {
namespace {

TEST(FloorFrame, LevelOpticalCameraMapsForwardToX)
{
  const Eigen::Isometry3d m = floorFrame({-Eigen::Vector3d::UnitY(), 0.8}, Eigen::Vector3d::UnitZ());
  // A point 2 m ahead, 0.5 m to the right, 0.3 m below the camera stands 0.5 m above the floor.
  EXPECT_TRUE((m * Eigen::Vector3d(0.5, 0.3, 2.0)).isApprox(Eigen::Vector3d(2.0, -0.5, 0.5), 1e-12))
      << (m * Eigen::Vector3d(0.5, 0.3, 2.0)).transpose();
}

TEST(FloorFrame, ExactlyLevelBodyFrameIsAPureLift)
{
  const Eigen::Isometry3d m = floorFrame({Eigen::Vector3d::UnitZ(), 0.5}, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(m.linear().isIdentity(1e-12)) << m.linear();
  EXPECT_TRUE(m.translation().isApprox(Eigen::Vector3d(0, 0, 0.5)));
}

TEST(FloorFrame, LookingStraightDownStillGivesARotation)
{
  const Eigen::Isometry3d m = floorFrame({-Eigen::Vector3d::UnitZ(), 1.0}, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(m.linear().determinant(), 1.0, 1e-12);
  EXPECT_TRUE((m.linear() * m.linear().transpose()).isIdentity(1e-12)) << m.linear();
}

}  // namespace
}  // namespace polygonal_perception::perception
