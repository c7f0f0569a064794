#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/projection_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// An upright camera frame: x ahead, y left, z up, on the floor.
Eigen::Isometry3d upright()
{
  return Eigen::Isometry3d::Identity();
}

PointView rowOf(const std::vector<test::PackedPoint>& points)
{
  return PointView::points(points.data(), static_cast<std::uint32_t>(points.size()), 1);
}

occupancy::BinaryGrid project(const PointView& points, const Eigen::Isometry3d& to_floor,
                              const Projection::Parameters& parameters = {},
                              const occupancy::GridParameters& grid = {})
{
  occupancy::BinaryGrid occupancy{occupancy::GridGeometry(grid)};
  Projection(parameters).project(points, to_floor, occupancy);
  return occupancy;
}

TEST(Projection, MarksTheCellThatAPointStandsIn)
{
  const occupancy::BinaryGrid grid = project(rowOf({{1.02F, 0.51F, 0.3F, 0.0F}}), upright());
  EXPECT_EQ(grid.count(), 1U);
  EXPECT_TRUE(grid.occupied(20, 60));
}

TEST(Projection, TakesHeightsFromTheLowestToTheHighestBothIncluded)
{
  Projection::Parameters parameters;
  parameters.min_height = 0.25;
  parameters.max_height = 0.5;
  const float below = std::nextafter(0.25F, 0.0F);
  const float above = std::nextafter(0.5F, 1.0F);
  EXPECT_EQ(
      project(rowOf({{1.0F, 0.0F, below, 0.0F}, {2.0F, 0.0F, above, 0.0F}}), upright(), parameters).count(),
      0U);
  EXPECT_EQ(
      project(rowOf({{1.0F, 0.0F, 0.25F, 0.0F}, {2.0F, 0.0F, 0.5F, 0.0F}}), upright(), parameters).count(),
      2U);
}

TEST(Projection, LeavesPointsBesideTheGridOut)
{
  const occupancy::BinaryGrid grid = project(rowOf({{-0.001F, 0.0F, 0.3F, 0.0F},
                                                    {5.0F, 0.0F, 0.3F, 0.0F},
                                                    {1.0F, 2.5F, 0.3F, 0.0F},
                                                    {1.0F, -2.51F, 0.3F, 0.0F}}),
                                             upright());
  EXPECT_EQ(grid.count(), 0U);
}

TEST(Projection, NothingStandsWhereTheNumbersAreNotFiniteOrHuge)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  std::vector<test::PackedPoint> points;
  for (const float odd : {nan, -nan, infinity, -infinity, 3e38F, -3e38F, 1e10F}) {
    for (int axis = 0; axis < 7; ++axis) {
      const auto component = [&](int bit, float good) { return ((axis + 1) >> bit & 1) != 0 ? odd : good; };
      points.push_back({component(0, 1.0F), component(1, 0.0F), component(2, 0.3F), odd});
    }
  }
  EXPECT_EQ(project(rowOf(points), upright()).count(), 0U);
  EXPECT_EQ(project(rowOf(points), test::tiltedCamera()).count(), 0U);
}

TEST(Projection, PixelsWithoutReturnAreNotTheCameraItself)
{
  // The camera is as high as an obstacle, and a depth of 0 would put the pixel where the camera is.
  const Eigen::Isometry3d low_camera = test::tiltedCamera(0.3);
  const PinholeRays rays = PinholeRays::make(40, 4, 500.0, 500.0, 20.0, 2.0);
  const std::vector<std::uint16_t> millimetres(160, 0);
  const std::vector<float> metres(160, 0.0F);
  const std::vector<float> negative(160, -0.1F);
  EXPECT_EQ(project(PointView::depth(millimetres.data(), 80, rays), low_camera).count(), 0U);
  EXPECT_EQ(project(PointView::depth(metres.data(), 160, rays), low_camera).count(), 0U);
  EXPECT_EQ(project(PointView::depth(negative.data(), 160, rays), low_camera).count(), 0U);
  EXPECT_EQ(project(rowOf({{0.0F, 0.0F, 0.0F, 1.0F}}), low_camera).count(), 0U) << "a cloud's";
}

TEST(Projection, ANumberOf65535IsNoReturn)
{
  const PinholeRays rays = PinholeRays::make(40, 4, 500.0, 500.0, 20.0, 2.0);
  // In a unit in which both lie in the grid.
  for (const auto& [number, marks] : {std::pair<std::uint16_t, bool>(65534, true), {65535, false}}) {
    const std::vector<std::uint16_t> depth(160, number);
    const PointView view = PointView::depth(depth.data(), 80, rays, 1e-5);
    EXPECT_EQ(project(view, test::tiltedCamera(0.3)).count() > 0, marks) << number;
  }
}

TEST(Projection, NothingStandsOutsideTheLimitsOfRange)
{
  const std::vector<test::PackedPoint> three = {
      {1.0F, 0.0F, 0.3F, 0.0F}, {2.0F, 0.0F, 0.3F, 0.0F}, {3.0F, 0.0F, 0.3F, 0.0F}};
  const PointView points = rowOf(three);
  EXPECT_EQ(project(points, upright()).count(), 3U);
  EXPECT_EQ(project(points.within({1.5, 2.5}), upright()).count(), 1U);
  EXPECT_EQ(project(points.within({1.5, 0.0}), upright()).count(), 2U);
}

TEST(Projection, NoTransformMarksNothingWhenItIsNotANumber)
{
  Eigen::Isometry3d broken = upright();
  broken.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(project(rowOf({{1.0F, 0.0F, 0.3F, 0.0F}}), broken).count(), 0U);
}

TEST(Projection, CountsThePointsOfACell)
{
  // As many points as there are in a row of a large image, so that the counters have to saturate.
  for (const int in_cell : {1, 2, 254, 255, 2000}) {
    const std::vector<test::PackedPoint> points(static_cast<std::size_t>(in_cell),
                                                {1.02F, 0.51F, 0.3F, 0.0F});
    for (const int enough : {1, 2, 3, 254, 255}) {
      Projection::Parameters parameters;
      parameters.min_points_per_cell = enough;
      EXPECT_EQ(project(rowOf(points), upright(), parameters).count(), in_cell >= enough ? 1U : 0U)
          << in_cell << " points where " << enough << " are enough";
    }
  }
}

TEST(Projection, ForgetsTheLastFrame)
{
  Projection projection{Projection::Parameters{}};
  occupancy::BinaryGrid grid{occupancy::GridGeometry(occupancy::GridParameters{})};
  projection.project(rowOf({{1.0F, 0.0F, 0.3F, 0.0F}}), upright(), grid);
  projection.project(rowOf({{2.0F, 0.0F, 0.3F, 0.0F}}), upright(), grid);
  EXPECT_EQ(grid.count(), 1U);
  EXPECT_TRUE(grid.occupied(40, 50));
}

TEST(Projection, AnEmptyFrameLeavesTheGridFree)
{
  EXPECT_EQ(project(PointView(), upright()).count(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::perception
