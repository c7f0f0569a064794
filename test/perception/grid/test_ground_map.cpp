#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/perception/floor/floor_frame.hpp"
#include "polygonal_perception/perception/grid/drop_offs.hpp"
#include "polygonal_perception/perception/grid/ground_map.hpp"
#include "polygonal_perception/perception/grid/projection.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

/// A surface with a sample every 20 cm between two distances, right across the grid.
GroundSurface surface(float slope, float offset, float from, float to)
{
  GroundSurface surface{{slope, 0.0F}, offset, {}};
  for (float x = from; x <= to; x += 0.2F) {
    for (float y = -2.4F; y < 2.5F; y += 0.2F) surface.samples.emplace_back(x, y);
  }
  return surface;
}

GroundSurface surfaceOf(const geometry::Plane& plane, const Eigen::Isometry3d& to_floor)
{
  GroundSurface surface;
  surface.setPlane(plane, to_floor);
  return surface;
}

const occupancy::GridGeometry kGrid{occupancy::GridParameters{}};

TEST(GroundSurface, IsThePlaneInTheFloorFrame)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.3);
  const Eigen::Isometry3d to_floor = floorFrame(floor, ViewAxes{});
  const GroundSurface level = surfaceOf(floor, to_floor);
  EXPECT_NEAR(level.at(3.0F, 1.0F), 0.0F, 1e-6F);
  EXPECT_NEAR(surfaceOf(test::raised(floor, 0.2), to_floor).at(3.0F, 1.0F), 0.2F, 1e-6F);
  // As a camera sees a floor that looks farther down: it rises ahead.
  const GroundSurface rising = surfaceOf(test::floorSeenFrom(0.8, 0.4), to_floor);
  EXPECT_NEAR(rising.at(1.0F, 0.0F) - rising.at(0.0F, 0.0F), std::tan(0.1F), 1e-6F);
}

TEST(GroundMap, HeightsAreThoseOfTheSurfaceThatWasSeenThere)
{
  GroundMap map;
  map.build(kGrid, {surface(0.0F, 0.0F, 0.1F, 2.0F), surface(0.1F, -0.2F, 2.1F, 4.9F)});
  EXPECT_NEAR(map.at(1.0F, 0.0F).higher, 0.0F, 1e-6F);
  EXPECT_NEAR(map.at(3.0F, 0.0F).higher, 0.1F, 1e-6F);
  EXPECT_NEAR(map.at(4.5F, -2.0F).higher, 0.25F, 1e-6F);
  EXPECT_NEAR(map.at(7.0F, 0.0F).higher, 0.5F, 1e-6F) << "beyond the grid its last cell's surface goes on";
  EXPECT_LE(map.lowest(), 0.0F);
  EXPECT_GT(map.lowest(), -0.05F);
  EXPECT_GE(map.highest(), 0.3F);
  EXPECT_LT(map.highest(), 0.35F);
}

TEST(GroundMap, BetweenTwoSurfacesTheHigherOneCounts)
{
  GroundMap map;
  // A crest: the ramp would go on rising.
  map.build(kGrid, {surface(0.1F, 0.0F, 0.1F, 2.0F), surface(0.0F, 0.2F, 2.1F, 4.9F)});
  EXPECT_NEAR(map.at(2.15F, 0.0F).higher, 0.215F, 1e-6F);
  EXPECT_NEAR(map.at(3.0F, 0.0F).higher, 0.2F, 1e-6F);
}

TEST(GroundMap, WhereNothingWasSeenTheFloorCountsToo)
{
  GroundMap map;
  map.build(kGrid, {surface(0.0F, 0.0F, 0.1F, 1.0F), surface(0.2F, -0.2F, 1.1F, 2.0F)});
  EXPECT_NEAR(map.at(1.8F, 0.0F).lower, 0.16F, 1e-6F) << "seen";
  const GroundMap::Span beyond = map.at(4.0F, 0.0F);
  EXPECT_NEAR(beyond.lower, 0.0F, 1e-6F);
  EXPECT_NEAR(beyond.higher, 0.6F, 1e-6F);
  // A box on the level ground at the ramp's end, lower than the ramp would be if it went on.
  const float box[] = {4.02F, 0.02F, 0.4F};
  occupancy::BinaryGrid grid(kGrid);
  PointView::CloudStrides strides;
  strides.row_step = strides.point_step = sizeof box;
  Projection{Projection::Parameters{}}.project(PointView::cloud(box, 1, 1, strides),
                                               Eigen::Isometry3d::Identity(), grid, {nullptr, &map});
  EXPECT_EQ(grid.count(), 1U);
}

TEST(GroundMap, ASurfaceWithoutSamplesIsNowhere)
{
  GroundMap map;
  map.build(kGrid, {GroundSurface{}, surface(0.0F, 0.3F, 1.0F, 4.9F)});
  EXPECT_NEAR(map.at(0.2F, 0.0F).higher, 0.3F, 1e-6F);
}

/// Points on a ramp of 0.1 from 2 m on, and one thing that stands on it.
TEST(GroundMap, WhatStandsOnARampStandsAndTheRampDoesNot)
{
  struct Point
  {
    float x, y, z;
  };
  std::vector<Point> points;
  for (float x = 0.2F; x < 4.9F; x += 0.05F) points.push_back({x, 0.0F, std::max(0.0F, 0.1F * (x - 2.0F))});
  points.push_back({3.52F, 1.0F, 0.15F + 0.05F});   // 5 cm above the ramp
  points.push_back({3.52F, -1.0F, 0.15F + 0.58F});  // 58 cm, which is above max_height over the floor
  points.push_back({3.52F, 2.0F, 0.15F + 0.65F});   // above max_height over the ramp
  GroundMap map;
  map.build(kGrid, {surface(0.0F, 0.0F, 0.1F, 2.0F), surface(0.1F, -0.2F, 2.1F, 4.9F)});
  occupancy::BinaryGrid grid(kGrid);
  const PointView view = PointView::points(points.data(), static_cast<std::uint32_t>(points.size()), 1);
  Projection projection{Projection::Parameters{}};
  projection.project(view, Eigen::Isometry3d::Identity(), grid, {nullptr, &map});
  EXPECT_EQ(grid.count(), 2U);
  EXPECT_TRUE(grid.occupied(70, 70));
  EXPECT_TRUE(grid.occupied(70, 30));

  projection.project(view, Eigen::Isometry3d::Identity(), grid);
  EXPECT_GT(grid.count(), 40U) << "without the map the ramp is an obstacle";
  std::vector<Eigen::Vector3f> standing;
  projection.collect(view, Eigen::Isometry3d::Identity(), kGrid, standing, {nullptr, &map});
  EXPECT_EQ(standing.size(), 2U);
}

/// A cloud of many rows to a cell over a ramp that leads down from 1 m on, with things on it in some of the rows.
TEST(GroundMap, WithWhatIsObservedTheSameStandsAndTheRampIsSeen)
{
  struct Point
  {
    float x, y, z;
  };
  constexpr int kColumns = 64;
  constexpr int kRows = 800;
  std::vector<Point> points;
  for (int v = 0; v < kRows; ++v) {
    const float x = 0.3F + 0.004F * static_cast<float>(v);
    const float ground = std::min(0.0F, -0.1F * (x - 1.0F));
    for (int u = 0; u < kColumns; ++u) {
      const bool is_thing = v % 37 == 5 && u % 16 == 3;
      points.push_back({x, 0.03F * static_cast<float>(u - kColumns / 2), ground + (is_thing ? 0.05F : 0.0F)});
    }
  }
  GroundMap map;
  map.build(kGrid, {surface(0.0F, 0.0F, 0.1F, 1.0F), surface(-0.1F, 0.1F, 1.1F, 4.9F)});
  const PointView view = PointView::points(points.data(), kColumns, kRows);
  Projection projection{Projection::Parameters{}};
  occupancy::BinaryGrid plain(kGrid);
  occupancy::BinaryGrid with_observed(kGrid);
  occupancy::ObservedCells observed;
  projection.project(view, Eigen::Isometry3d::Identity(), plain, {nullptr, &map});
  projection.project(view, Eigen::Isometry3d::Identity(), with_observed, {nullptr, &map}, {&observed});
  EXPECT_EQ(plain.count(), 80U);
  EXPECT_EQ(with_observed.cells(), plain.cells());
  for (int i = 8; i < 68; ++i)
    EXPECT_EQ(observed.floor[static_cast<std::size_t>(50 * kGrid.cells_x + i)], 1) << "x = " << 0.05 * i;
}

TEST(GroundMap, ARampDownIsNoDrop)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.0);
  const Eigen::Isometry3d to_floor = floorFrame(floor, ViewAxes{});
  const geometry::Plane down = test::floorSeenFrom(0.8 * std::cos(0.1) - 2.0 * std::sin(0.1), -0.1);
  test::PlaneScene scene(320, 240, 200.0);
  scene.add(down, [](const Eigen::Vector3d& p) { return p.z() >= 2.0; });
  scene.add(floor, [](const Eigen::Vector3d& p) { return p.z() < 2.0; });
  GroundMap map;
  std::vector<GroundSurface> surfaces = {surface(0.0F, 0.0F, 0.1F, 2.0F), surfaceOf(down, to_floor)};
  surfaces[1].samples = surface(0.0F, 0.0F, 2.1F, 4.9F).samples;
  map.build(kGrid, surfaces);
  occupancy::BinaryGrid grid(kGrid);
  const DropOffs drop_offs({0.1});
  drop_offs.mark(scene.view(), to_floor, grid);
  EXPECT_GT(grid.count(), 0U);
  grid.reset(kGrid);
  drop_offs.mark(scene.view(), to_floor, grid, &map);
  EXPECT_EQ(grid.count(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::perception
