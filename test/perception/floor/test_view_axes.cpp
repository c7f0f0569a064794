#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "polygonal_perception/perception/floor/view_axes.hpp"

namespace polygonal_perception::perception {
namespace {

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

  /// Puts a number of points where their pixels do not look.
  void spoil(int count)
  {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::size_t> any(0, points_.size() - 1);
    for (int k = 0; k < count; ++k) points_[any(random)] = Eigen::Vector3f(-1.0F, 2.0F, -3.0F);
  }

  std::optional<Pinhole> pinhole() const
  {
    PointView::CloudStrides strides;
    strides.point_step = sizeof(Eigen::Vector3f);
    strides.row_step = kWidth * strides.point_step;
    SampleGrid samples{SampleGrid::Parameters{}};
    samples.update(PointView::cloud(points_.data(), kWidth, 48, strides));
    return fitPinhole(samples);
  }
  std::optional<ViewAxes> axes() const
  {
    const std::optional<Pinhole> pinhole = this->pinhole();
    if (!pinhole) return std::nullopt;
    return viewAxesOf(*pinhole);
  }
  /// The point of a pixel.
  Eigen::Vector3d point(int u, int v) const
  {
    return points_[static_cast<std::size_t>(v * kWidth + u)].cast<double>();
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

void expectAxes(const WideView& view, const Eigen::Vector3d& forward, const Eigen::Vector3d& upward,
                const std::string& what)
{
  const auto axes = view.axes();
  ASSERT_TRUE(axes) << what;
  EXPECT_TRUE(axes->forward.isApprox(forward, 1e-6)) << what << ": forward " << axes->forward.transpose();
  EXPECT_TRUE(axes->upward.isApprox(upward, 1e-6)) << what << ": upward " << axes->upward.transpose();
  EXPECT_EQ(axes->source, ViewAxes::Source::kPixels) << what;
}

const Eigen::Matrix3f kOptical = Eigen::Matrix3f::Identity();

TEST(PinholeFit, SaysWhereEachPixelLooks)
{
  for (const Eigen::Matrix3f& axes : {kOptical, intoBodyFrame()}) {
    const WideView view(axes, 0, 63);
    const auto pinhole = view.pinhole();
    ASSERT_TRUE(pinhole);
    for (int v = 0; v < 48; v += 5) {
      for (int u = 0; u < 64; u += 7) {
        const Eigen::Vector3d direction = pinhole->direction_of_pixel * Eigen::Vector3d(u, v, 1.0);
        EXPECT_LT((direction.normalized() - view.point(u, v).normalized()).norm(), 1e-5) << u << ' ' << v;
      }
    }
  }
}

TEST(ViewAxes, AreReadOffThePixelsOfOpticalAndBodyFrames)
{
  expectAxes(WideView(kOptical, 0, 63), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), "optical");
  expectAxes(WideView(intoBodyFrame(), 0, 63), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), "body");
}

TEST(ViewAxes, DoNotTurnToTheSideThatReturnsPoints)
{
  for (const auto& [first, last] : {std::pair(0, 12), std::pair(50, 63)}) {
    const std::string what = "columns " + std::to_string(first) + " to " + std::to_string(last);
    expectAxes(WideView(kOptical, first, last), Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), what);
    expectAxes(WideView(intoBodyFrame(), first, last), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(),
               what);
  }
}

TEST(ViewAxes, AreThoseOfAnyFrame)
{
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  for (int k = 0; k < 200; ++k) {
    const Eigen::Quaternionf turn =
        Eigen::Quaternionf(normal(random), normal(random), normal(random), normal(random)).normalized();
    const auto axes = WideView(turn.toRotationMatrix(), 0, 63).axes();
    ASSERT_TRUE(axes) << "case " << k;
    // Within the 0.2 degrees in which they become the frame's own axes.
    EXPECT_GT(axes->forward.dot((turn * Eigen::Vector3f::UnitZ()).cast<double>()), 0.99999) << "case " << k;
    EXPECT_GT(axes->upward.dot((turn * -Eigen::Vector3f::UnitY()).cast<double>()), 0.99999) << "case " << k;
    EXPECT_NEAR(axes->forward.dot(axes->upward), 0.0, 1e-9) << "case " << k;
  }
}

TEST(ViewAxes, PointsOfAnotherMemoryDoNotDecide)
{
  WideView view(kOptical, 0, 63);
  view.spoil(100);  // of 3072
  expectAxes(view, Eigen::Vector3d::UnitZ(), -Eigen::Vector3d::UnitY(), "3 percent garbage");
}

TEST(ViewAxes, AreNotReadOffTooFewPixels)
{
  EXPECT_FALSE(WideView(kOptical, 64, 64).axes()) << "no return";
  EXPECT_FALSE(WideView(kOptical, 20, 20).axes()) << "a single column";
}

TEST(ViewAxes, AreNotReadOffWhatIsNoPinhole)
{
  // A lidar: the directions are those of a sphere's degrees.
  std::vector<Eigen::Vector3f> points;
  for (int v = 0; v < 32; ++v) {
    for (int u = 0; u < 256; ++u) {
      const float azimuth = 6.2832F * static_cast<float>(u) / 256.0F;
      const float elevation = 0.02F * static_cast<float>(16 - v);
      points.emplace_back(5.0F * std::cos(azimuth) * std::cos(elevation),
                          5.0F * std::sin(azimuth) * std::cos(elevation), 5.0F * std::sin(elevation));
    }
  }
  PointView::CloudStrides strides;
  strides.point_step = sizeof(Eigen::Vector3f);
  strides.row_step = 256 * strides.point_step;
  SampleGrid samples{SampleGrid::Parameters{}};
  samples.update(PointView::cloud(points.data(), 256, 32, strides));
  EXPECT_FALSE(fitPinhole(samples));
}

TEST(ViewAxes, ByConventionAreThoseOfAnOpticalFrameUnlessZIsUp)
{
  const auto forward = [](PointLayout layout, const Eigen::Vector3d& up) {
    return conventionalViewAxes(layout, up).forward;
  };
  EXPECT_EQ(forward(PointLayout::kCloud, {0.0, -1.0, 0.0}), Eigen::Vector3d::UnitZ());
  EXPECT_EQ(forward(PointLayout::kCloud, {0.0, -0.2, -1.0}), Eigen::Vector3d::UnitZ()) << "looks down";
  EXPECT_EQ(forward(PointLayout::kCloud, {0.1, 0.0, 1.0}), Eigen::Vector3d::UnitX());
  EXPECT_EQ(forward(PointLayout::kDepthMetres, {0.1, 0.0, 1.0}), Eigen::Vector3d::UnitZ())
      << "a depth image has an optical frame";
}

TEST(ViewAxes, AlongADirectionHaveTheUpperBorderUp)
{
  const ViewAxes axes = viewAxesAlong({0.0, -3.0, 0.0}, {0.0, -1.0, -2.0});
  EXPECT_EQ(axes.forward, -Eigen::Vector3d::UnitY());
  EXPECT_TRUE(axes.upward.isApprox(-Eigen::Vector3d::UnitZ())) << axes.upward.transpose();
  EXPECT_NEAR(viewAxesAlong(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()).upward.z(), 0.0, 1e-12);
}

}  // namespace
}  // namespace polygonal_perception::perception
