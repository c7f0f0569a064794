#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/floor/ground_planes.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kHeight = 0.8;  // [m] of the camera
const geometry::Plane kFloor = test::floorSeenFrom(kHeight, 0.3);

/// In the optical frame: along the floor and up from it, from the foot of the camera.
const Eigen::Vector3d kAhead(0.0, -std::sin(0.3), std::cos(0.3));
double ahead(const Eigen::Vector3d& point)
{
  return kAhead.dot(point);
}

/// A plane that meets the floor `start` [m] ahead and rises (or falls) from there.
geometry::Plane ramp(double start, double slope, double height = 0.0)
{
  const Eigen::Vector3d normal = std::cos(slope) * kFloor.normal - std::sin(slope) * kAhead;
  const Eigen::Vector3d hinge = start * kAhead + (height - kHeight) * kFloor.normal;
  return {normal, -normal.dot(hinge)};
}

class GroundPlanesTest : public ::testing::Test
{
protected:
  GroundPlanesTest()
  {
    parameters_.max_slope = 12 * kDegree;
    ground_ = GroundPlanes(parameters_);
  }

  const std::vector<GroundPlane>& find(const test::PlaneScene& scene)
  {
    SampleGrid grid{SampleGrid::Parameters{}};
    grid.update(scene.view());
    const FloorState& floor = tracker_.update(scene.view(), grid, 1.0, {});
    EXPECT_EQ(floor.status, FloorStatus::kFound);
    EXPECT_GT(floor.floor.plane.normal.dot(kFloor.normal), 0.9999) << "another floor";
    return ground_.find(tracker_.detector(), floor.floor.plane);
  }

  /// Level floor up to `start`, and then another plane.
  test::PlaneScene thenAPlane(double start, const geometry::Plane& other, double noise = 0.002)
  {
    test::PlaneScene scene(320, 240, 285.0, noise);
    scene.add(kFloor, [=](const Eigen::Vector3d& p) { return ahead(p) < start; });
    scene.add(other, [=](const Eigen::Vector3d& p) { return ahead(p) >= start; });
    return scene;
  }

  GroundPlanes::Parameters parameters_;
  FloorTracker tracker_{FloorTracker::Parameters{}, FloorDetector::Parameters{}};
  GroundPlanes ground_{parameters_};
};

TEST_F(GroundPlanesTest, ARampUpOrDownContinuesTheFloor)
{
  for (const double slope : {-10.0, -5.0, 5.0, 10.0}) {
    tracker_.reset();
    const auto& ground = find(thenAPlane(2.0, ramp(2.0, slope * kDegree)));
    ASSERT_EQ(ground.size(), 2U) << slope;
    EXPECT_GT(ground[1].plane.normal.dot(ramp(2.0, slope * kDegree).normal), 0.9999) << slope;
    EXPECT_GT(ground[0].samples.size(), 100U) << slope;
    for (const Eigen::Vector3f& sample : ground[1].samples)
      EXPECT_GT(ahead(sample.cast<double>()), 1.9) << slope;
  }
}

TEST_F(GroundPlanesTest, WhatARampLeadsToIsGroundToo)
{
  const double slope = 8 * kDegree;
  const double rise = std::tan(slope);
  test::PlaneScene scene(320, 240, 285.0, 0.002);
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return ahead(p) < 1.2; });
  scene.add(ramp(1.2, slope), [](const Eigen::Vector3d& p) { return ahead(p) >= 1.2 && ahead(p) < 2.4; });
  scene.add(test::raised(kFloor, 1.2 * rise), [](const Eigen::Vector3d& p) { return ahead(p) >= 2.4; });
  EXPECT_EQ(find(scene).size(), 3U);
}

TEST_F(GroundPlanesTest, TooSteepIsNone)
{
  EXPECT_EQ(find(thenAPlane(1.5, ramp(1.5, 15 * kDegree))).size(), 1U);
}

TEST_F(GroundPlanesTest, AStepIsNone)
{
  for (const double height : {-0.5, -0.2, -0.1, -0.05, 0.04, 0.05, 0.1, 0.15, 0.3}) {
    tracker_.reset();
    EXPECT_EQ(find(thenAPlane(1.5, test::raised(kFloor, height))).size(), 1U) << height;
  }
  for (const double height : {0.1, 0.15, 0.3}) {
    tracker_.reset();
    EXPECT_EQ(find(thenAPlane(1.5, ramp(1.5, 6 * kDegree, height))).size(), 1U)
        << "a ramp that begins " << height << " m above the floor";
  }
}

TEST_F(GroundPlanesTest, AWallAndABoxAreNone)
{
  test::PlaneScene scene(320, 240, 285.0, 0.002);
  scene.add(kFloor);
  scene.add({-kAhead, 3.0});
  scene.add(test::raised(kFloor, 0.25), [](const Eigen::Vector3d& p) {
    return ahead(p) > 1.4 && ahead(p) < 2.0 && std::abs(p.x()) < 0.4;
  });
  EXPECT_EQ(find(scene).size(), 1U);
}

TEST_F(GroundPlanesTest, ARampThatFillsTheViewMeetsTheFloorOnTheWayToIt)
{
  const auto fills = [&](const geometry::Plane& plane) {
    test::PlaneScene scene(320, 240, 285.0, 0.002);
    scene.add(plane);
    SampleGrid grid{SampleGrid::Parameters{}};
    grid.update(scene.view());
    FloorTracker::Parameters parameters;
    parameters.mount.has_slopes = true;
    FloorTracker tracker(parameters, FloorDetector::Parameters{});
    const FloorState& floor = tracker.update(scene.view(), grid, 1.0, {{}, kFloor, {}});
    EXPECT_EQ(floor.status, FloorStatus::kAssumed);
    return ground_.find(tracker.detector(), floor.floor.plane).size();
  };
  for (const double slope : {-8.0, -4.0, 4.0, 8.0}) {
    for (const double start : {0.1, 0.3, 0.6})
      EXPECT_EQ(fills(ramp(start, slope * kDegree)), 2U) << slope << ", " << start;
  }
  EXPECT_EQ(fills(test::raised(kFloor, 0.15)), 1U) << "a platform";
  EXPECT_EQ(fills(ramp(0.3, 6 * kDegree, 0.1)), 1U) << "a ramp on a platform";
  EXPECT_EQ(fills(ramp(3.0, 6 * kDegree)), 1U)
      << "a slope that falls to a floor beyond: what is there before it?";
}

TEST_F(GroundPlanesTest, NothingIsAskedForByDefault)
{
  EXPECT_FALSE(GroundPlanes(GroundPlanes::Parameters{}).isActive());
  EXPECT_TRUE(GroundPlanes(parameters_).isActive());
}

}  // namespace
}  // namespace polygonal_perception::perception
