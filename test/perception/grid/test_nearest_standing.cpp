#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "perception/grid/nearest_standing.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/every_kernel.hpp"
#include "support/projection_scene.hpp"
#include "support/random_frame.hpp"
#include "support/reference_projection.hpp"

namespace polygonal_perception::perception {

namespace {

using test::EveryKernel;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const BearingBins kAllRound{-3.1, 0.05, 125};

FloorPointNoise noNoise(float sensor_height)
{
  return {SensorNoise{0.0, 0.0, 0.0}, sensor_height, Eigen::Matrix3f::Zero()};
}

/// The nearest of each bin as plainly as it can be written, pixel by pixel.
std::vector<float> reference(const PointView& view, const Eigen::Isometry3d& to_floor,
                             const Projection::Parameters& parameters, const BearingBins& bins)
{
  std::vector<float> nearest(bins.count, kInfinity);
  for (std::uint32_t v = 0; v < view.height(); ++v) {
    for (std::uint32_t u = 0; u < view.width(); ++u) {
      const Eigen::Vector3d p = to_floor * view.point(u, v).cast<double>();
      if (!(p.z() > parameters.min_height && p.z() < parameters.max_height)) continue;
      const double bin = std::floor((std::atan2(p.y(), p.x()) - bins.first) / bins.increment + 0.5);
      if (!(bin >= 0.0 && bin < bins.count)) continue;
      float& of_bin = nearest[static_cast<std::size_t>(bin)];
      of_bin = std::min(of_bin, static_cast<float>(p.head<2>().norm()));
    }
  }
  return nearest;
}

/// The least of a bin and its neighbours.
float leastAround(const std::vector<float>& values, std::size_t k)
{
  float least = values[k];
  if (k > 0) least = std::min(least, values[k - 1]);
  if (k + 1 < values.size()) least = std::min(least, values[k + 1]);
  return least;
}

std::vector<float> ranges(const NearestStanding& nearest)
{
  std::vector<float> ranges;
  for (const float squared : nearest.squared()) ranges.push_back(std::sqrt(squared));
  return ranges;
}

TEST_P(EveryKernel, FindsTheNearestOfTheReferenceInEachDirection)
{
  std::mt19937 random(17);
  std::size_t compared = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const test::RandomFrame frame(random);
    Projection::Parameters parameters;
    parameters.max_height = 1.0;
    const Eigen::Isometry3d to_floor = test::tiltedCamera(std::uniform_real_distribution<>(0.3, 1.2)(random));
    occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
    occupancy::ObservedCells observed;
    NearestStanding nearest;
    nearest.setUp(kAllRound, 1, noNoise(static_cast<float>(to_floor.translation().z())), 6.0);
    Projection(parameters, kernel()).project(frame.view(), to_floor, grid, {}, {&observed, &nearest});

    const std::vector<float> found = ranges(nearest);
    const std::vector<float> expected = reference(frame.view(), to_floor, parameters, kAllRound);
    for (std::size_t bin = 0; bin < found.size(); ++bin) {
      // What rounding puts in the bin beside it is as good.
      const float slack = 1e-3F;
      if (expected[bin] < 1e3F) {
        ASSERT_LE(leastAround(found, bin), expected[bin] + slack) << "trial " << trial << ", bin " << bin;
      }
      if (found[bin] < 1e3F) {
        ASSERT_GE(found[bin], leastAround(expected, bin) - slack) << "trial " << trial << ", bin " << bin;
      }
      compared += expected[bin] < 1e3F ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 20000U) << "too few bins to compare anything";
}

INSTANTIATE_TEST_SUITE_P(All, EveryKernel, testing::ValuesIn(test::kKernelNames), test::nameOfKernel);

/// A frame of 64 x 2 points in the floor frame itself, the sensor 1 m above the floor.
class PlainFrame : public testing::Test
{
protected:
  PlainFrame() : points_(128, {NAN, NAN, NAN, 0.0F})
  {
    to_floor_.translation().z() = 1.0;
    parameters_.min_points_per_cell = 1;
  }

  void put(std::size_t pixel, float x, float y, float height)
  {
    points_[pixel] = {x, y, height - 1.0F, 0.0F};
  }

  /// [m] The range of the bin in which a direction lies.
  float rangeAt(double bearing, const HeightRules& rules = {})
  {
    NearestStanding nearest;
    nearest.setUp(kAllRound, 2, noise_, 6.0);
    occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
    occupancy::ObservedCells observed;
    const PointView view = PointView::points(points_.data(), 64, 2);
    Projection(parameters_)
        .project(ignored_.empty() ? view : view.without(ignored_), to_floor_, grid, rules,
                 {&observed, &nearest});
    const auto bin = static_cast<std::size_t>(std::lround((bearing - kAllRound.first) / kAllRound.increment));
    return ranges(nearest)[bin];
  }

  std::vector<test::PackedPoint> points_;
  Eigen::Isometry3d to_floor_ = Eigen::Isometry3d::Identity();
  Projection::Parameters parameters_;
  FloorPointNoise noise_ = noNoise(1.0F);
  IgnoredBoxes ignored_;
};

TEST_F(PlainFrame, TheNearestOfADirectionCounts)
{
  put(3, 3.0F, 0.0F, 0.2F);
  put(67, 2.0F, 0.0F, 0.2F);
  put(10, -0.3F, -0.4F, 0.2F);
  EXPECT_FLOAT_EQ(rangeAt(0.0), 2.0F);
  EXPECT_FLOAT_EQ(rangeAt(std::atan2(-0.4, -0.3)), 0.5F) << "behind the sensor, and beside the grid";
  EXPECT_EQ(rangeAt(1.0), kInfinity);
}

TEST_F(PlainFrame, TheFloorAndWhatIsTooHighCountForNothing)
{
  put(3, 1.0F, 0.0F, 0.02F);
  put(4, 1.5F, 0.0F, 0.7F);
  EXPECT_EQ(rangeAt(0.0), kInfinity);
}

TEST_F(PlainFrame, WhatTheFloorsNoiseCouldBeDoesNotCount)
{
  noise_ = {SensorNoise{0.05, 0.0, 0.0}, 1.0F, Eigen::Matrix3f::Zero()};
  // At (2, 0) a floor point's height has a standard deviation of 0.05 / sqrt(5) = 22 mm.
  put(3, 2.0F, 0.0F, 0.13F);
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  put(4, 2.0F, 0.0F, 0.14F);
  EXPECT_FLOAT_EQ(rangeAt(0.0), 2.0F);
}

TEST_F(PlainFrame, WhereTheFloorMayBeTiltedWhatIsLowDoesNotCount)
{
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  covariance(0, 0) = 0.01F * 0.01F;  // 1 cm a metre ahead
  noise_ = {SensorNoise{0.0, 0.0, 0.0}, 1.0F, covariance};
  put(3, 2.0F, 0.0F, 0.11F);
  put(4, 0.1F, 2.0F, 0.11F);
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  EXPECT_FLOAT_EQ(rangeAt(std::atan2(2.0, 0.1)), std::hypot(2.0F, 0.1F));
}

TEST_F(PlainFrame, CellsWithTooFewPointsCountForNothing)
{
  parameters_.min_points_per_cell = 2;
  put(3, 2.01F, 0.01F, 0.2F);
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  put(9, 2.02F, 0.02F, 0.2F);
  EXPECT_NEAR(rangeAt(0.0), 2.01, 0.02);
}

TEST_F(PlainFrame, WhatIsInAnIgnoredBoxCountsForNothing)
{
  ignored_.add(Eigen::Isometry3d::Identity(),
               {Eigen::Vector3d(0.5, -1.0, -1.0), Eigen::Vector3d(1.5, 1.0, 1.0)});
  put(3, 1.0F, 0.0F, 0.2F);
  put(4, 3.0F, 0.0F, 0.2F);
  put(5, -2.0F, -0.1F, 0.3F);
  EXPECT_FLOAT_EQ(rangeAt(0.0), 3.0F);
  EXPECT_NEAR(rangeAt(-3.09), 2.0, 0.01) << "behind, beside the grid";
}

TEST_F(PlainFrame, HeightsCountFromTheGround)
{
  // A ramp of 20 % from 1 m ahead on.
  GroundSurface floor;
  floor.setPlane({Eigen::Vector3d::UnitZ(), 0.0}, Eigen::Isometry3d::Identity());
  GroundSurface ramp;
  const Eigen::Vector3d up = Eigen::Vector3d(-0.2, 0.0, 1.0).normalized();
  ramp.setPlane({up, -up.dot(Eigen::Vector3d(1.0, 0.0, 0.0))}, Eigen::Isometry3d::Identity());
  for (float x = 0.0F; x < 3.0F; x += 0.1F) {
    for (float y = -1.0F; y <= 1.0F; y += 0.1F) (x < 1.0F ? floor : ramp).samples.emplace_back(x, y);
  }
  GroundMap map;
  map.build(occupancy::GridGeometry(occupancy::GridParameters{}), {floor, ramp});
  put(3, 2.0F, 0.0F, 0.2F);   // on the ramp
  put(4, 2.5F, 0.0F, 0.45F);  // 15 cm above it
  EXPECT_FLOAT_EQ(rangeAt(0.0, {nullptr, &map}), 2.5F);
}

}  // namespace

}  // namespace polygonal_perception::perception
