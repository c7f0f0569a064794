#include <gtest/gtest.h>

#include <cmath>

#include "perception/scan/view_bearings.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "polygonal_perception/perception/floor/floor_frame.hpp"

namespace polygonal_perception::perception {

namespace {

using geometry::kPi;

/// A depth camera of 90 x 90 degrees, `height` above the floor, that looks `pitch` down and is rolled.
class TestView
{
public:
  explicit TestView(double pitch, double roll = 0.0, double height = 1.0)
      : rays_(PinholeRays::make(100, 100, 50.0, 50.0, 49.5, 49.5)),
        image_(10000, 0.0F),
        points_(PointView::depth(image_.data(), 400, rays_)),
        pixels_(rays_.pixelOfDirection())
  {
    const Eigen::Vector3d up(std::sin(roll) * std::cos(pitch), -std::cos(roll) * std::cos(pitch),
                             -std::sin(pitch));
    to_floor_ = floorFrame({up, height}, ViewAxes{});
  }

  FloorScanner::View view() const { return {points_, pixels_, to_floor_}; }

private:
  PinholeRays rays_;
  std::vector<float> image_;
  PointView points_;
  std::optional<Eigen::Matrix3f> pixels_;
  Eigen::Isometry3d to_floor_;
};

TEST(ViewBearings, ALevelCameraSeesItsFieldOfView)
{
  const TestView camera(0.0);
  const ViewBearings bearings = viewBearings(camera.view());
  EXPECT_NEAR(bearings.first, -kPi / 4.0, 1e-6);
  EXPECT_NEAR(bearings.last, kPi / 4.0, 1e-6);
}

TEST(ViewBearings, ATiltedCameraSeesFartherRoundBelow)
{
  // Of the lower corners (1, 1, 1), turned 30 degrees down.
  const double ahead = std::cos(kPi / 6.0) - std::sin(kPi / 6.0);
  const TestView camera(kPi / 6.0);
  const ViewBearings bearings = viewBearings(camera.view());
  EXPECT_NEAR(bearings.last, std::atan2(1.0, ahead), 1e-6);
  EXPECT_NEAR(bearings.first, -bearings.last, 1e-6);
}

TEST(ViewBearings, ACameraThatSeesTheGroundBelowItSeesAllRound)
{
  for (const double pitch : {0.3 * kPi, 0.4 * kPi, 0.5 * kPi}) {
    const TestView camera(pitch);
    const ViewBearings bearings = viewBearings(camera.view());
    EXPECT_NEAR(bearings.last - bearings.first, 2.0 * kPi, 1e-6) << "pitch " << pitch;
  }
}

TEST(ViewBearings, WithoutAPinholeAllRound)
{
  const TestView camera(0.0);
  const FloorScanner::View known = camera.view();
  const std::optional<Eigen::Matrix3f> nobody_knows;
  const ViewBearings bearings = viewBearings({known.points, nobody_knows, known.to_floor_frame});
  EXPECT_NEAR(bearings.last - bearings.first, 2.0 * kPi, 1e-9);
  EXPECT_GT(ViewOnFloor({known.points, nobody_knows, known.to_floor_frame}).along(0.0).from,
            ViewOnFloor({known.points, nobody_knows, known.to_floor_frame}).along(0.0).to);
}

TEST(ViewBearings, WhereABearingIsConstantARowIsAsGoodAsAll)
{
  const TestView level(0.0);
  EXPECT_EQ(rowsOfOneBearing(level.view(), 0.004), 100U);
  // Rolled by 30 degrees: tan 30 of a row's 1.15 degrees in the middle.
  const TestView rolled(0.0, kPi / 6.0);
  EXPECT_LT(rowsOfOneBearing(rolled.view(), 0.05), 6U);
  EXPECT_GT(rowsOfOneBearing(rolled.view(), 0.05), 1U);
}

TEST(ViewOnFloor, BeginsBelowTheImageAndEndsAboveIt)
{
  // 45 degrees down and a field of view of 90: from straight below to the horizon.
  EXPECT_NEAR(ViewOnFloor(TestView(kPi / 4.0).view()).along(0.0).from, 0.0, 1e-5);
  EXPECT_GT(ViewOnFloor(TestView(kPi / 4.0).view()).along(0.0).to, 1e4);
  // 60 degrees down: up to 15 degrees below the horizon.
  EXPECT_NEAR(ViewOnFloor(TestView(kPi / 3.0).view()).along(0.0).to, std::tan(kPi * 75.0 / 180.0), 1e-4);
  // Level: from 45 degrees below the horizon on.
  EXPECT_NEAR(ViewOnFloor(TestView(0.0).view()).along(0.0).from, 1.0, 1e-5);
}

TEST(ViewOnFloor, EndsAtTheSides)
{
  const ViewOnFloor level(TestView(0.0).view());
  const auto inside = level.along(0.2 * kPi);
  EXPECT_LT(inside.from, inside.to);
  const auto beside = level.along(0.3 * kPi);
  EXPECT_GT(beside.from, beside.to);
  const auto behind = level.along(kPi);
  EXPECT_GT(behind.from, behind.to);
}

}  // namespace

}  // namespace polygonal_perception::perception
