#include <gtest/gtest.h>

#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

using Reason = FloorAbsence::Reason;

/// Why no floor is found in a scene by a camera that thinks that it is level.
std::optional<FloorAbsence> absenceIn(const test::PlaneScene& scene,
                                      const FloorDetector::Parameters& parameters = {})
{
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  FloorTracker tracker(FloorTracker::Parameters{}, parameters);
  return tracker.update(scene.view(), grid, 1.0, {}).absence;
}

test::PlaneScene floorAt(double height)
{
  test::PlaneScene scene;
  scene.add(test::floorSeenFrom(height, 0.4));
  return scene;
}

TEST(FloorAbsence, OfAFloorThatIsFoundThereIsNone)
{
  EXPECT_FALSE(absenceIn(floorAt(0.8)));
}

TEST(FloorAbsence, WithoutReturnsThereIsNoPlane)
{
  const auto absence = absenceIn(test::PlaneScene());
  ASSERT_TRUE(absence);
  EXPECT_EQ(absence->reason, Reason::kNoPlane);
  EXPECT_EQ(absence->point_share, 0.0);
}

TEST(FloorAbsence, BeforeAWallNothingFacesUpAndTheWallIsNamed)
{
  test::PlaneScene scene;
  scene.add({-Eigen::Vector3d::UnitZ(), 1.5});
  const auto absence = absenceIn(scene);
  ASSERT_TRUE(absence);
  EXPECT_EQ(absence->reason, Reason::kNoneFacesUp);
  EXPECT_TRUE(absence->normal.isApprox(-Eigen::Vector3d::UnitZ(), 1e-3)) << absence->normal.transpose();
  EXPECT_NEAR(absence->tilt, 1.5708, 1e-3);
  EXPECT_EQ(absence->point_share, 1.0);
}

TEST(FloorAbsence, OfACameraUpsideDownTheFloorIsThePlaneThatFacesDown)
{
  test::PlaneScene scene;
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.4);
  scene.add({-floor.normal, floor.distance});
  scene.add({-Eigen::Vector3d::UnitZ(), 5.0});
  const auto absence = absenceIn(scene);
  ASSERT_TRUE(absence);
  EXPECT_EQ(absence->reason, Reason::kNoneFacesUp);
  EXPECT_GT(absence->tilt, 1.5) << "what initial_up would have to be is in its normal: "
                                << absence->normal.transpose();
}

TEST(FloorAbsence, ACameraLowerOrHigherThanItCanBeIsToldItsHeight)
{
  FloorDetector::Parameters parameters;
  parameters.selection.min_camera_height = 0.5;
  parameters.selection.max_camera_height = 1.0;
  for (const auto& [height, reason] : {std::pair(0.4, Reason::kTooNear), std::pair(1.3, Reason::kTooFar)}) {
    const auto absence = absenceIn(floorAt(height), parameters);
    ASSERT_TRUE(absence) << height << " m";
    EXPECT_EQ(absence->reason, reason) << height << " m";
    EXPECT_NEAR(absence->height, height, 0.01);
  }
}

TEST(FloorAbsence, APlaneThatIsNoFloorForAllItsSamplesIsUnlikely)
{
  FloorDetector::Parameters parameters;
  parameters.selection.least_score = 1e3;
  const auto absence = absenceIn(floorAt(0.8), parameters);
  ASSERT_TRUE(absence);
  EXPECT_EQ(absence->reason, Reason::kUnlikely);
  EXPECT_NEAR(absence->height, 0.8, 0.01);
}

TEST(FloorAbsence, OfTwoPlanesThatFaceUpTheLargerIsNamed)
{
  FloorDetector::Parameters parameters;
  parameters.selection.least_score = 1e3;
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.4);
  test::PlaneScene scene;
  scene.add(floor);
  scene.add({floor.normal, 0.6}, [](const Eigen::Vector3d& p) { return p.x() > 0.2 && p.z() < 2.0; });
  const auto absence = absenceIn(scene, parameters);
  ASSERT_TRUE(absence);
  EXPECT_NEAR(absence->height, 1.0, 0.01);
}

}  // namespace
}  // namespace polygonal_perception::perception
