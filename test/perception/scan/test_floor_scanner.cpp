#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "perception/grid/nearest_standing.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "polygonal_perception/perception/scan/floor_scanner.hpp"

namespace polygonal_perception::perception {

namespace {

using geometry::kPi;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A depth camera 1 m above a floor, 90 x 90 degrees, that looks 45 degrees down unless said: it sees the floor from
/// below itself to the horizon. What stands is put into the image of a floor that is seen everywhere.
class FloorScannerTest : public testing::Test
{
protected:
  FloorScannerTest() : rays_(PinholeRays::make(100, 100, 50.0, 50.0, 49.5, 49.5)), image_(10000, 0.0F)
  {
    parameters_.scan_angle_increment = 0.05;
    parameters_.scan_range_max = 3.0;
  }

  Eigen::Isometry3d toFloor() const
  {
    return floorFrame({Eigen::Vector3d(0.0, -std::cos(pitch_), -std::sin(pitch_)), 1.0}, ViewAxes{});
  }
  /// The pixel that sees a place.
  float& pixel(double x, double y, double z)
  {
    const Eigen::Vector3d p = toFloor().inverse() * Eigen::Vector3d(x, y, z);
    const Eigen::Vector3f uv = rays_.pixelOfDirection() * p.cast<float>();
    const auto u = static_cast<std::size_t>(std::lround(uv.x() / uv.z()));
    const auto v = static_cast<std::size_t>(std::lround(uv.y() / uv.z()));
    return image_.at(v * 100 + u);
  }
  void put(double x, double y, double z)
  {
    pixel(x, y, z) = static_cast<float>((toFloor().inverse() * Eigen::Vector3d(x, y, z)).z());
  }

  const LevelScan& scan(bool is_floor_seen = true)
  {
    const PointView points = PointView::depth(image_.data(), 400, rays_);
    const std::optional<Eigen::Matrix3f> pixels = rays_.pixelOfDirection();
    const Eigen::Isometry3d to_floor = toFloor();
    const FloorScanner::View view{points, pixels, to_floor};
    scanner_.cover(view);
    occupancy::BinaryGrid occupancy{occupancy::GridGeometry(occupancy::GridParameters{})};
    const FloorPointNoise noise(SensorNoise{}, 1.0F, Eigen::Matrix3f::Zero());
    Projection(Projection::Parameters{})
        .project(points, to_floor, occupancy, {}, {&observed_, &scanner_.beginFrame(view, noise)});
    observed_.floor.assign(occupancy.geometry().size(), is_floor_seen ? 1 : 0);
    for (const Eigen::Vector2d& place : unseen_)
      observed_.floor[*occupancy.geometry().cellOf(place.x(), place.y())] = 0;
    for (const Eigen::Vector2d& place : drops_)
      occupancy.row(0)[*occupancy.geometry().cellOf(place.x(), place.y())] = 1;
    scanner_.finishFrame(view, occupancy, observed_, scan_);
    return scan_;
  }
  float rangeAt(double bearing) const
  {
    return scan_.ranges.at(
        static_cast<std::size_t>(std::lround((bearing - scan_.bins.first) / scan_.bins.increment)));
  }
  void useParameters() { scanner_ = FloorScanner(parameters_); }

  PinholeRays rays_;
  std::vector<float> image_;  // [m]
  double pitch_ = kPi / 4.0;
  FloorScanner::Parameters parameters_;
  FloorScanner scanner_{parameters_};
  occupancy::ObservedCells observed_;
  std::vector<Eigen::Vector2d> unseen_;
  std::vector<Eigen::Vector2d> drops_;
  LevelScan scan_;
};

TEST_F(FloorScannerTest, NothingOnSeenFloorIsInfinite)
{
  useParameters();
  scan();
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  EXPECT_EQ(rangeAt(0.5), kInfinity);
}

TEST_F(FloorScannerTest, WhereTheFloorIsNotSeenNobodyKnows)
{
  useParameters();
  scan(false);
  for (const float range : scan_.ranges) ASSERT_TRUE(std::isnan(range)) << range;
}

TEST_F(FloorScannerTest, OneCellThatIsNotSeenIsEnough)
{
  useParameters();
  unseen_ = {{1.53, 0.01}, {1.53, -0.01}};
  scan();
  EXPECT_TRUE(std::isnan(rangeAt(0.0))) << rangeAt(0.0);
  EXPECT_EQ(rangeAt(0.2), kInfinity);
}

TEST_F(FloorScannerTest, AnObstacleEndsItsDirectionWhateverTheFloor)
{
  useParameters();
  put(2.0, 0.0, 0.2);
  scan();
  const float with_floor = rangeAt(0.0);
  EXPECT_NEAR(with_floor, 2.0, 0.05);
  scan(false);
  EXPECT_EQ(rangeAt(0.0), with_floor);
  EXPECT_TRUE(std::isnan(rangeAt(0.2)));
}

TEST_F(FloorScannerTest, WhatIsBeyondTheRangeIsNoRange)
{
  useParameters();
  put(4.0, 0.0, 0.3);
  scan();
  EXPECT_EQ(rangeAt(0.0), kInfinity);
}

TEST_F(FloorScannerTest, ADropEndsItsDirection)
{
  useParameters();
  drops_ = {{1.53, 0.01}, {1.53, -0.01}, {1.58, 0.01}};
  scan();
  EXPECT_NEAR(rangeAt(0.0), 1.5, 0.06);
  put(1.2, 0.0, 0.2);
  scan();
  EXPECT_NEAR(rangeAt(0.0), 1.2, 0.05) << "what stands before it comes first";
}

TEST_F(FloorScannerTest, BelowTheViewNobodyNeedsToSee)
{
  pitch_ = 0.0;  // level: the floor is in view from 1 m on
  useParameters();
  unseen_ = {{0.53, 0.01}, {0.53, -0.01}};
  scan();
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  unseen_ = {{1.12, 0.01}, {1.12, -0.01}};
  scan();
  EXPECT_TRUE(std::isnan(rangeAt(0.0)));
}

TEST_F(FloorScannerTest, AViewThatEndsBeforeTheRangeClearsNothing)
{
  pitch_ = kPi / 3.0;  // up to 3.73 m
  useParameters();
  scan();
  EXPECT_EQ(rangeAt(0.0), kInfinity);
  parameters_.scan_range_max = 4.0;
  useParameters();
  scan();
  EXPECT_TRUE(std::isnan(rangeAt(0.0)));
}

TEST_F(FloorScannerTest, BinsCoverTheViewAndOnlyGrow)
{
  pitch_ = 0.0;
  useParameters();
  scan();
  EXPECT_NEAR(scan_.bins.first, -5.0 * kPi / 18.0, 1e-9) << "45 degrees, rounded up to tens";
  EXPECT_NEAR(scan_.bins.bearing(scan_.bins.count - 1), 5.0 * kPi / 18.0, 0.05);
  pitch_ = 0.1;
  scan();
  EXPECT_NEAR(scan_.bins.first, -5.0 * kPi / 18.0, 1e-9) << "tilted by a little there is room";
  pitch_ = 0.4;
  scan();
  const BearingBins tilted = scan_.bins;
  EXPECT_LT(tilted.first, -6.0 * kPi / 18.0);
  pitch_ = 0.0;
  scan();
  EXPECT_EQ(scan_.bins, tilted);
  scanner_.reset();
  scan();
  EXPECT_NEAR(scan_.bins.first, -5.0 * kPi / 18.0, 1e-9);
}

TEST_F(FloorScannerTest, AWholeTurnHasNoBinTwice)
{
  pitch_ = kPi / 2.0;
  useParameters();
  scan();
  const BearingBins& bins = scan_.bins;
  EXPECT_NEAR(bins.first, -kPi, 1e-9);
  EXPECT_LT(bins.bearing(bins.count - 1), kPi);
  EXPECT_GE(bins.bearing(bins.count), kPi - bins.increment);
}

TEST_F(FloorScannerTest, AnglesThatAreSetAreTaken)
{
  parameters_.scan_angle_min = -0.5;
  parameters_.scan_angle_max = 1.0;
  useParameters();
  scan();
  EXPECT_EQ(scan_.bins.count, 31U);
  EXPECT_NEAR(scan_.bins.first, -0.5, 1e-9);
  EXPECT_NEAR(scan_.bins.bearing(30), 1.0, 1e-9);
}

}  // namespace

}  // namespace polygonal_perception::perception
