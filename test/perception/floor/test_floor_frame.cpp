#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

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

const Eigen::Vector3d kOpticalUp = -Eigen::Vector3d::UnitY();
const Eigen::Vector3d kBodyUp = Eigen::Vector3d::UnitZ();

/// A cloud of a wide camera, 120 degrees across, 0.8 m above a floor and before a wall, in the frame of any
/// axes.
class WideView
{
public:
  /// @param first_column,last_column  returns come only from these; the image has 64
  WideView(const Eigen::Matrix3f& from_optical, int first_column, int last_column)
  {
    const float slope = std::tan(1.047F) / 31.5F;
    for (int v = 0; v < 48; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const Eigen::Vector3f ray((static_cast<float>(u) - 31.5F) * slope,
                                  (static_cast<float>(v) - 15.5F) * slope, 1.0F);
        const float depth = ray.y() > 0.2F ? 0.8F / ray.y() : 4.0F;
        const bool seen = u >= first_column && u <= last_column;
        points_.push_back(seen ? Eigen::Vector3f(from_optical * (depth * ray))
                               : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
      }
    }
  }

  std::optional<Eigen::Vector3d> forward(const Eigen::Vector3d& up) const
  {
    PointView::CloudStrides strides;
    strides.point_step = sizeof(Eigen::Vector3f);
    strides.row_step = kWidth * strides.point_step;
    const PointView view = PointView::cloud(points_.data(), kWidth, 48, strides);
    SampleGrid samples{SampleGrid::Parameters{}};
    samples.update(view);
    return forwardAxis(view, samples, up);
  }

private:
  static constexpr int kWidth = 64;
  std::vector<Eigen::Vector3f> points_;
};

/// From an optical frame into a body frame: x ahead, y left, z up.
Eigen::Matrix3f intoBodyFrame()
{
  Eigen::Matrix3f turn;
  turn << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return turn;
}

TEST(ForwardAxis, IsTheViewingAxisOfOpticalAndBodyFrames)
{
  EXPECT_EQ(WideView(Eigen::Matrix3f::Identity(), 0, 63).forward(kOpticalUp), Eigen::Vector3d::UnitZ());
  EXPECT_EQ(WideView(intoBodyFrame(), 0, 63).forward(kBodyUp), Eigen::Vector3d::UnitX());
}

TEST(ForwardAxis, DoesNotTurnToTheSideThatReturnsPoints)
{
  for (const auto& [first, last] : {std::pair(0, 12), std::pair(50, 63)}) {
    EXPECT_EQ(WideView(Eigen::Matrix3f::Identity(), first, last).forward(kOpticalUp),
              Eigen::Vector3d::UnitZ())
        << "columns " << first << " to " << last;
    EXPECT_EQ(WideView(intoBodyFrame(), first, last).forward(kBodyUp), Eigen::Vector3d::UnitX())
        << "columns " << first << " to " << last;
  }
}

TEST(ForwardAxis, IsNotDownInAFrameThatIsKeptLevelBelowASteepCamera)
{
  for (const double pitch : {0.3, 0.8, 1.2}) {
    const Eigen::Matrix3f level =
        Eigen::AngleAxisf(static_cast<float>(pitch), Eigen::Vector3f::UnitY()) * intoBodyFrame();
    EXPECT_EQ(WideView(level, 0, 63).forward(kBodyUp), Eigen::Vector3d::UnitX()) << "pitch " << pitch;
    // In the camera's own body frame up tilts instead.
    const Eigen::Vector3d up(-std::sin(pitch), 0.0, std::cos(pitch));
    EXPECT_EQ(WideView(intoBodyFrame(), 0, 63).forward(up), Eigen::Vector3d::UnitX()) << "pitch " << pitch;
  }
}

TEST(ForwardAxis, IsUnknownWithoutAReturn)
{
  EXPECT_FALSE(WideView(Eigen::Matrix3f::Identity(), 64, 64).forward(kOpticalUp));
}

}  // namespace
}  // namespace polygonal_perception::perception
