#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "polygonal_perception/perception/floor/floor_mount.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;
const geometry::Plane kMount = test::floorSeenFrom(0.8, 0.3);

DetectedFloor floorAt(const geometry::Plane& plane)
{
  DetectedFloor floor;
  floor.plane = plane;
  return floor;
}

TEST(MountError, IsTiltAndHeightAgainstTheMount)
{
  const MountError error =
      mountError(floorAt(test::floorSeenFrom(0.82, 0.3 + 3 * kDegree)), kMount, FloorMountParameters{});
  EXPECT_NEAR(error.tilt, 3 * kDegree, 1e-9);
  EXPECT_NEAR(error.height, 0.02, 1e-9);
  EXPECT_TRUE(error.is_beyond) << "3 degrees are five standard deviations";
}

TEST(MountError, IsBeyondOnlyWhereBothTogetherAreSureEnough)
{
  FloorMountParameters parameters;
  parameters.mount_tilt_sigma = 0.01;
  parameters.mount_height_sigma = 0.01;
  EXPECT_FALSE(mountError(floorAt(test::floorSeenFrom(0.82, 0.329)), kMount, parameters).is_beyond);
  EXPECT_TRUE(mountError(floorAt(test::floorSeenFrom(0.82, 0.331)), kMount, parameters).is_beyond);
  EXPECT_TRUE(mountError(floorAt(test::floorSeenFrom(0.831, 0.3)), kMount, parameters).is_beyond);
  // A floor that is itself uncertain contradicts nobody.
  DetectedFloor vague = floorAt(test::floorSeenFrom(0.831, 0.331));
  vague.covariance.diagonal().setConstant(0.02 * 0.02);
  EXPECT_FALSE(mountError(vague, kMount, parameters).is_beyond);
}

TEST(AssumedFloor, HasTheMountsCovariance)
{
  FloorMountParameters parameters;
  const DetectedFloor floor = assumedFloor(kMount, parameters);
  EXPECT_EQ(floor.plane.distance, kMount.distance);
  EXPECT_NEAR(std::sqrt(floor.covariance(3, 3)), parameters.mount_height_sigma, 1e-12);
  const Eigen::Vector3d across = kMount.normal.unitOrthogonal();
  const Eigen::Matrix3d normal = floor.covariance.topLeftCorner<3, 3>();
  EXPECT_NEAR(std::sqrt(across.dot(normal * across)), parameters.mount_tilt_sigma, 1e-12);
  EXPECT_NEAR(kMount.normal.dot(normal * kMount.normal), 0.0, 1e-12);
}

/// A tracker that is told the mount, fed at 10 Hz.
class MountedTrackerTest : public ::testing::Test
{
protected:
  const FloorState& see(const test::PlaneScene& scene, const FloorHints& hints)
  {
    grid_.update(scene.view());
    stamp_ += 0.1;
    return tracker_.update(scene.view(), grid_, stamp_, hints);
  }
  const FloorState& see(const test::PlaneScene& scene, const geometry::Plane& mount = kMount)
  {
    return see(scene, FloorHints{{}, mount, {}});
  }

  static test::PlaneScene floor(const geometry::Plane& plane)
  {
    test::PlaneScene scene;
    scene.add(plane);
    return scene;
  }
  static test::PlaneScene wall() { return floor({-Eigen::Vector3d::UnitZ(), 1.0}); }

  SampleGrid grid_{SampleGrid::Parameters{}};
  FloorTracker tracker_{FloorTracker::Parameters{}, FloorDetector::Parameters{}};
  double stamp_ = 0.0;
};

TEST_F(MountedTrackerTest, BeforeAWallTheFloorIsAssumed)
{
  const FloorState& state = see(wall());
  ASSERT_EQ(state.status, FloorStatus::kAssumed);
  EXPECT_EQ(state.floor.plane.normal, kMount.normal);
  EXPECT_EQ(state.floor.plane.distance, kMount.distance);
  EXPECT_EQ(state.floor.sample_count, 0U);
  ASSERT_TRUE(state.absence);
  EXPECT_EQ(state.absence->reason, FloorAbsence::Reason::kNoneFacesUp);
  EXPECT_TRUE(state.absence->up_is_from_tf);
}

TEST_F(MountedTrackerTest, AFloorThatWasSeenIsHeldFirst)
{
  ASSERT_EQ(see(floor(kMount)).status, FloorStatus::kFound);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(see(wall()).status, FloorStatus::kHeld) << k;
  EXPECT_EQ(see(wall()).status, FloorStatus::kAssumed);
  EXPECT_EQ(see(floor(kMount)).status, FloorStatus::kFound);
}

TEST_F(MountedTrackerTest, ACameraThatTurnsOnItsMountHoldsNothing)
{
  ASSERT_EQ(see(floor(kMount)).status, FloorStatus::kFound);
  const geometry::Plane turned = test::floorSeenFrom(0.8, 0.3 - 10 * kDegree);
  const FloorState& state = see(wall(), turned);
  ASSERT_EQ(state.status, FloorStatus::kAssumed);
  EXPECT_EQ(state.floor.plane.normal, turned.normal);
}

TEST_F(MountedTrackerTest, WithACoveredLensNothingIsAssumed)
{
  EXPECT_EQ(see(test::PlaneScene()).status, FloorStatus::kNotFound);
}

TEST_F(MountedTrackerTest, ATableOrAPlatformIsNotTheFloorAndAFloorBelowItIs)
{
  for (const double height : {0.1, 0.14, 0.3, 0.5}) {
    tracker_.reset();
    const FloorState& state = see(floor(test::raised(kMount, height)));
    ASSERT_EQ(state.status, FloorStatus::kAssumed) << height;
    EXPECT_EQ(state.absence->reason, FloorAbsence::Reason::kTooNear) << height;
    EXPECT_TRUE(state.absence->bounds_are_mounts) << height;
  }
  for (const double depth : {0.1, 0.3, 1.0}) {
    tracker_.reset();
    const FloorState& state = see(floor(test::raised(kMount, -depth)));
    ASSERT_EQ(state.status, FloorStatus::kAssumed) << depth;
    EXPECT_EQ(state.absence->reason, FloorAbsence::Reason::kTooFar) << depth;
  }
}

TEST_F(MountedTrackerTest, AKnockedCameraFindsItsFloorAndDisagrees)
{
  for (const double tilt : {-10.0, -3.0, 3.0, 10.0}) {
    tracker_.reset();
    const geometry::Plane truth = test::floorSeenFrom(0.8, 0.3 + tilt * kDegree);
    const FloorState& state = see(floor(truth));
    ASSERT_EQ(state.status, FloorStatus::kFound) << tilt;
    EXPECT_GT(state.floor.plane.normal.dot(truth.normal), 0.99999) << tilt;
    ASSERT_TRUE(state.mount_error) << tilt;
    EXPECT_NEAR(state.mount_error->tilt, std::abs(tilt) * kDegree, 0.002) << tilt;
    EXPECT_TRUE(state.mount_error->is_beyond) << tilt;
  }
  tracker_.reset();
  EXPECT_FALSE(see(floor(test::floorSeenFrom(0.805, 0.31))).mount_error->is_beyond);
}

TEST_F(MountedTrackerTest, AMountBeyondTheBoundsOnTheCamerasHeightHolds)
{
  const geometry::Plane high = test::floorSeenFrom(4.0, 0.9);
  test::PlaneScene scene(160, 120, 142.5, 0.0);
  scene.add(high);
  EXPECT_EQ(see(scene, high).status, FloorStatus::kFound) << "max_camera_height is 3 m";
}

TEST_F(MountedTrackerTest, WhatTfDoesNotCallLevelIsNoFloor)
{
  // The cloud says it is in a body frame, but its points are in an optical one.
  const FloorHints body{{}, {}, Eigen::Vector3d::UnitZ()};
  const FloorState& state = see(floor(kMount), body);
  ASSERT_EQ(state.status, FloorStatus::kNotFound);
  ASSERT_TRUE(state.absence);
  EXPECT_EQ(state.absence->reason, FloorAbsence::Reason::kNotLevelInTf);
  EXPECT_GT(state.absence->tilt, 60 * kDegree);

  const FloorHints right{{}, {}, kMount.normal};
  EXPECT_EQ(see(floor(kMount), right).status, FloorStatus::kFound);
}

}  // namespace
}  // namespace polygonal_perception::perception
