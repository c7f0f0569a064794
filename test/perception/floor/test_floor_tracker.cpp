#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kPeriod = 1.0 / 30.0;  // [s]

/// Feeds scenes to a tracker at 30 Hz.
class FloorTrackerTest : public ::testing::Test
{
protected:
  const FloorState& see(const test::PlaneScene& scene, const std::optional<Eigen::Vector3d>& up_from_tf = {})
  {
    grid_.update(scene.view());
    stamp_ += kPeriod;
    return tracker_.update(scene.view(), grid_, stamp_, {up_from_tf, {}, {}});
  }

  /// @return the state after so many frames of the same scene
  const FloorState& see(const test::PlaneScene& scene, int frames)
  {
    for (int k = 1; k < frames; ++k) see(scene);
    return see(scene);
  }

  static test::PlaneScene bare(const geometry::Plane& floor)
  {
    test::PlaneScene scene;
    scene.add(floor);
    return scene;
  }

  static test::PlaneScene wall()
  {
    test::PlaneScene scene;
    scene.add({-Eigen::Vector3d::UnitZ(), 1.0});
    return scene;
  }

  static test::PlaneScene ceiling()
  {
    test::PlaneScene scene;
    scene.add({Eigen::Vector3d(0.0, std::sqrt(0.5), -std::sqrt(0.5)), 1.5});
    return scene;
  }

  /// The own floor ends at a depth, 1.2 m above a lower storey.
  static test::PlaneScene ledge(const geometry::Plane& own, double end)
  {
    test::PlaneScene scene;
    scene.add(test::raised(own, -1.2));
    scene.add(own, [end](const Eigen::Vector3d& p) { return p.z() < end; });
    return scene;
  }

  /// A table top ends at a depth, 0.75 m above the floor.
  static test::PlaneScene table(const geometry::Plane& floor, double end)
  {
    test::PlaneScene scene;
    scene.add(floor);
    scene.add(test::raised(floor, 0.75), [end](const Eigen::Vector3d& p) { return p.z() < end; });
    return scene;
  }

  void expectFound(const FloorState& state, const geometry::Plane& truth)
  {
    ASSERT_EQ(state.status, FloorStatus::kFound);
    EXPECT_NEAR(state.floor.plane.distance, truth.distance, 0.002);
    EXPECT_GT(state.floor.plane.normal.dot(truth.normal), 0.99999) << state.floor.plane.normal.transpose();
    EXPECT_EQ(state.age, 0.0);
  }

  SampleGrid grid_{SampleGrid::Parameters{}};
  FloorTracker tracker_{FloorTracker::Parameters{}, FloorDetector::Parameters{}};
  double stamp_ = 100.0;
};

TEST_F(FloorTrackerTest, FeedsTheNormalBackAsTheUpVector)
{
  // The camera tilts by 2 degrees a frame until it looks down by 70: beyond the seed's reach, but never far
  // from the last frame's normal.
  for (double pitch = 20.0; pitch <= 70.0; pitch += 2.0) {
    const geometry::Plane floor = test::floorSeenFrom(1.0, pitch * kDegree);
    expectFound(see(bare(floor)), floor);
  }
  tracker_.reset();
  EXPECT_EQ(see(bare(test::floorSeenFrom(1.0, 70 * kDegree))).status, FloorStatus::kNotFound);
}

TEST_F(FloorTrackerTest, StartsFromTfWhereTfKnowsUp)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 75 * kDegree);
  EXPECT_EQ(see(bare(floor)).status, FloorStatus::kNotFound);
  expectFound(see(bare(floor), floor.normal), floor);
}

TEST_F(FloorTrackerTest, HoldsAFloorThatIsCoveredAndThenGivesItUp)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 3);
  const double last_seen = stamp_;
  while (stamp_ + kPeriod < last_seen + 0.5) {
    const FloorState& state = see(test::PlaneScene());
    ASSERT_EQ(state.status, FloorStatus::kHeld);
    EXPECT_NEAR(state.age, stamp_ - last_seen, 1e-9);
    EXPECT_NEAR(state.floor.plane.distance, 0.8, 0.002);
  }
  see(test::PlaneScene());
  EXPECT_EQ(see(test::PlaneScene()).status, FloorStatus::kNotFound);
}

TEST_F(FloorTrackerTest, RecoversAfterTheCameraWasCovered)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  see(test::PlaneScene(), 40);
  expectFound(see(bare(floor)), floor);
}

TEST_F(FloorTrackerTest, RecoversAfterALookAtTheCeiling)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  EXPECT_NE(see(ceiling(), 5).status, FloorStatus::kFound);
  EXPECT_EQ(see(ceiling(), 40).status, FloorStatus::kNotFound);
  expectFound(see(bare(floor)), floor);
}

TEST_F(FloorTrackerTest, RecoversAfterALookAtAWall)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  EXPECT_EQ(see(wall(), 5).status, FloorStatus::kHeld);
  EXPECT_EQ(see(wall(), 40).status, FloorStatus::kNotFound);
  expectFound(see(bare(floor)), floor);
}

TEST_F(FloorTrackerTest, KeepsItsOwnFloorWhileItDrivesUpToALedge)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  // At 0.94 m the own floor leaves the view.
  for (double end = 3.0; end > 1.02; end -= 0.02) expectFound(see(ledge(floor, end)), floor);
}

TEST_F(FloorTrackerTest, ALowerStoreyIsNoFloorWhenTheOwnOneIsOutOfView)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  for (double end = 3.0; end > 0.94; end -= 0.02) see(ledge(floor, end));
  const test::PlaneScene lower = bare(test::raised(floor, -1.2));
  EXPECT_EQ(see(lower, 5).status, FloorStatus::kHeld);
  EXPECT_EQ(see(lower, 150).status, FloorStatus::kNotFound);
}

TEST_F(FloorTrackerTest, ATableTopIsNoFloorWhenTheFloorIsOutOfView)
{
  const geometry::Plane floor = test::floorSeenFrom(1.2, 0.5);
  see(bare(floor), 10);
  for (double edge = 0.8; edge < 4.0; edge += 0.1) see(table(floor, edge));
  EXPECT_NE(see(bare(test::raised(floor, 0.75)), 30).status, FloorStatus::kFound);
}

TEST_F(FloorTrackerTest, ADropThatComesIntoViewAtOnceIsNotTheFloor)
{
  // Somebody opens a door, and up to a third of what is seen lies a storey lower. (With half of it ViewChange
  // has the view for a new one, and the tracker forgets what it knows.)
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  for (const double end : {2.0, 1.8, 1.7, 1.6, 1.55}) {
    tracker_.reset();
    see(bare(floor), 30);
    const FloorState& state = see(ledge(floor, end));
    ASSERT_EQ(state.status, FloorStatus::kFound) << "the own floor ends " << end << " m away";
    EXPECT_NEAR(state.floor.plane.distance, 0.8, 0.01) << "the own floor ends " << end << " m away";
  }
}

TEST_F(FloorTrackerTest, FollowsACameraThatRises)
{
  for (double height = 0.6; height < 1.4; height += 0.02) {
    const geometry::Plane floor = test::floorSeenFrom(height, 0.5);
    expectFound(see(bare(floor)), floor);
  }
}

TEST_F(FloorTrackerTest, ATimeThatJumpsBackIsAFreshStart)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  see(bare(floor), 10);
  stamp_ -= 50.0;
  EXPECT_EQ(see(wall()).status, FloorStatus::kNotFound);
}

TEST_F(FloorTrackerTest, HoldsNothingWhileTheStampsStandStill)
{
  see(bare(test::floorSeenFrom(1.0, 0.4)));
  stamp_ -= kPeriod;
  EXPECT_EQ(see(wall()).status, FloorStatus::kNotFound) << "of unknown age";
  stamp_ -= kPeriod;
  EXPECT_EQ(see(bare(test::floorSeenFrom(1.0, 0.4))).status, FloorStatus::kFound)
      << "it is in this very frame";
  EXPECT_EQ(see(wall()).status, FloorStatus::kHeld) << "time passes again";
  stamp_ -= kPeriod;
  EXPECT_EQ(see(wall()).status, FloorStatus::kNotFound);
}

TEST_F(FloorTrackerTest, ResetForgetsTheFloor)
{
  see(bare(test::floorSeenFrom(0.8, 0.5)), 10);
  tracker_.reset();
  EXPECT_EQ(tracker_.state().status, FloorStatus::kNotFound);
  EXPECT_EQ(see(wall()).status, FloorStatus::kNotFound);
}

}  // namespace
}  // namespace polygonal_perception::perception
