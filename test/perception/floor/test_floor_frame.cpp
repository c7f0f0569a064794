#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

TEST(FloorFrame, LevelOpticalCameraMapsForwardToX)
{
  const Eigen::Isometry3d m = floorFrame({-Eigen::Vector3d::UnitY(), 0.8}, ViewAxes{});
  // A point 2 m ahead, 0.5 m to the right, 0.3 m below the camera stands 0.5 m above the floor.
  EXPECT_TRUE((m * Eigen::Vector3d(0.5, 0.3, 2.0)).isApprox(Eigen::Vector3d(2.0, -0.5, 0.5), 1e-12))
      << (m * Eigen::Vector3d(0.5, 0.3, 2.0)).transpose();
}

TEST(FloorFrame, ExactlyLevelBodyFrameIsAPureLift)
{
  const Eigen::Isometry3d m =
      floorFrame({Eigen::Vector3d::UnitZ(), 0.5}, {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), {}});
  EXPECT_TRUE(m.linear().isIdentity(1e-12)) << m.linear();
  EXPECT_TRUE(m.translation().isApprox(Eigen::Vector3d(0, 0, 0.5)));
}

/// What is ahead of a camera that is pitched down and rolled about its viewing axis, in its optical frame.
Eigen::Vector3d aheadOf(double pitch, double roll)
{
  return {std::sin(roll) * std::sin(pitch), -std::cos(roll) * std::sin(pitch), std::cos(pitch)};
}

TEST(FloorFrame, XIsAheadWhateverPitchAndRoll)
{
  constexpr double kSteepest = 1.5;  // [rad] beyond, the image's upper border is what is ahead
  for (double pitch = -kSteepest; pitch <= kSteepest; pitch += 0.1) {
    for (double roll = -3.1; roll <= 3.1; roll += 0.2) {
      const Eigen::Isometry3d m = floorFrame(test::floorSeenFrom(0.8, pitch, roll), ViewAxes{});
      EXPECT_TRUE(m.linear().row(0).transpose().isApprox(aheadOf(pitch, roll), 1e-9))
          << "pitch " << pitch << ", roll " << roll << ": " << m.linear().row(0);
    }
  }
}

TEST(FloorFrame, DoesNotTurnWhereACameraLooksStraightDown)
{
  for (double pitch = 1.3; pitch < 1.9; pitch += 0.01) {
    const Eigen::Isometry3d m = floorFrame(test::floorSeenFrom(0.8, pitch), ViewAxes{});
    // Beyond 93 degrees it looks back between its own legs, and what is ahead is where it looks.
    const double sign = std::cos(pitch) < -0.05 ? -1.0 : 1.0;
    EXPECT_TRUE(m.linear().row(0).transpose().isApprox(sign * aheadOf(pitch, 0.0), 1e-9))
        << "pitch " << pitch << ": " << m.linear().row(0);
    EXPECT_NEAR(m.linear().determinant(), 1.0, 1e-12);
  }
}

TEST(FloorFrame, LooksStraightUpWithTheImagesLowerBorderAhead)
{
  const Eigen::Isometry3d m = floorFrame({Eigen::Vector3d::UnitZ(), 1.0}, ViewAxes{});
  EXPECT_TRUE(m.linear().row(0).transpose().isApprox(Eigen::Vector3d::UnitY())) << m.linear().row(0);
}

}  // namespace
}  // namespace polygonal_perception::perception
