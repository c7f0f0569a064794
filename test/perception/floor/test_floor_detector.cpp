#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "polygonal_perception/perception/floor/floor_detector.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

constexpr double kDegree = 0.017453292519943295;

FloorPrior seed()
{
  FloorPrior prior;
  prior.up = -Eigen::Vector3d::UnitY();
  return prior;
}

std::optional<DetectedFloor> detect(const test::PlaneScene& scene, const FloorPrior& prior = seed(),
                                    const FloorDetector::Parameters& parameters = {})
{
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  FloorDetector detector(parameters);
  return detector.detect(scene.view(), grid, prior);
}

void expectFloor(const std::optional<DetectedFloor>& found, const geometry::Plane& truth)
{
  ASSERT_TRUE(found) << "no floor found, one at " << truth.distance << " m expected";
  EXPECT_NEAR(found->plane.distance, truth.distance, 0.002);
  const double angle = std::acos(std::min(1.0, found->plane.normal.dot(truth.normal)));
  EXPECT_LT(angle, 0.1 * kDegree) << "found " << found->plane.normal.transpose() << ", expected "
                                  << truth.normal.transpose();
}

TEST(FloorDetector, FindsABareFloor)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.4, 0.1);
  test::PlaneScene scene;
  scene.add(floor);
  const auto found = detect(scene);
  expectFloor(found, floor);
  EXPECT_GT(found->sample_count, 400U);
}

TEST(FloorDetector, FindsTheFloorOfALevelCamera)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.0);
  test::PlaneScene scene;
  scene.add(floor);
  expectFloor(detect(scene), floor);
}

TEST(FloorDetector, FindsTheFloorUpTo47DegreesFromTheSeed)
{
  // Pitched by 45 and rolled by 15 degrees the up vector is 47 degrees off the seed, beyond max_tilt.
  const geometry::Plane floor = test::floorSeenFrom(1.0, 45 * kDegree, 15 * kDegree);
  test::PlaneScene scene;
  scene.add(floor);
  expectFloor(detect(scene), floor);
}

TEST(FloorDetector, ATableTopThatFillsTheViewIsNotTheFloor)
{
  const geometry::Plane floor = test::floorSeenFrom(1.2, 0.6);
  test::PlaneScene scene;
  // Floor is seen only beyond the table's far edge, 1.9 m ahead.
  scene.add(floor);
  scene.add(test::raised(floor, 0.75), [](const Eigen::Vector3d& p) { return p.z() < 1.5; });
  expectFloor(detect(scene), floor);
}

TEST(FloorDetector, ASeedThatIs40DegreesOffDoesNotPutTheTableFirst)
{
  const geometry::Plane floor = test::floorSeenFrom(1.2, 0.6);
  test::PlaneScene scene;
  scene.add(floor);
  scene.add(test::raised(floor, 0.75), [](const Eigen::Vector3d& p) { return p.z() < 1.5; });
  for (const double sign : {-1.0, 1.0}) {
    FloorPrior prior = seed();
    prior.up = Eigen::AngleAxisd(sign * 40 * kDegree, Eigen::Vector3d::UnitX()) * floor.normal;
    expectFloor(detect(scene, prior), floor);
  }
}

TEST(FloorDetector, AWallIsNoFloor)
{
  test::PlaneScene scene;
  scene.add({-Eigen::Vector3d::UnitZ(), 1.0});
  const auto found = detect(scene);
  EXPECT_FALSE(found) << "found one at " << found->plane.distance;
}

TEST(FloorDetector, ACeilingIsNoFloor)
{
  test::PlaneScene scene;
  scene.add({Eigen::Vector3d::UnitY(), 1.5});
  const auto found = detect(scene);
  EXPECT_FALSE(found) << "found one at " << found->plane.distance;
}

TEST(FloorDetector, NoReturnsNoFloor)
{
  EXPECT_FALSE(detect(test::PlaneScene()));
}

TEST(FloorDetector, ARowThroughTheCentreIsNoFloor)
{
  // The points of one image row lie in a plane through the camera's centre, and fit it perfectly.
  test::PlaneScene scene;
  scene.add(test::floorSeenFrom(0.8, 0.5));
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    if (k / 160 != 119) scene.depth()[k] = std::numeric_limits<float>::quiet_NaN();
  }
  EXPECT_FALSE(detect(scene));
}

TEST(FloorDetector, APlaneAtAHeightThatTheCameraCannotHaveIsNoFloor)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  test::PlaneScene scene;
  scene.add(floor);
  FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = 0.7;
  EXPECT_FALSE(detect(scene, seed(), parameters));
  parameters.selection.max_camera_height = 3.0;
  parameters.selection.min_camera_height = 0.9;
  EXPECT_FALSE(detect(scene, seed(), parameters));
}

TEST(FloorDetector, WhatTheFinerFitSaysLiesWithinTheBoundsToo)
{
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  test::PlaneScene scene(160, 120, 142.5, 0.02);
  scene.add(floor);
  int found = 0;
  for (int step = -20; step <= 20; ++step) {
    const double bound = floor.distance + 0.0005 * step;
    FloorDetector::Parameters parameters;
    parameters.selection.min_camera_height = bound;
    const auto above = detect(scene, seed(), parameters);
    EXPECT_GE(above ? above->plane.distance : bound, bound);
    parameters.selection.min_camera_height = 0.05;
    parameters.selection.max_camera_height = bound;
    const auto below = detect(scene, seed(), parameters);
    EXPECT_LE(below ? below->plane.distance : bound, bound);
    found += (above ? 1 : 0) + (below ? 1 : 0);
  }
  EXPECT_GT(found, 0);
}

class AtALedge : public ::testing::Test
{
protected:
  AtALedge()
  {
    scene_.add(test::raised(own_, -1.2));
    scene_.add(own_, [](const Eigen::Vector3d& p) { return p.z() < 1.6; });
  }

  geometry::Plane own_ = test::floorSeenFrom(0.8, 0.5);
  test::PlaneScene scene_;
};

TEST_F(AtALedge, TheLowestPlaneWinsWithoutFurtherKnowledge)
{
  expectFloor(detect(scene_), test::raised(own_, -1.2));
}

TEST_F(AtALedge, ABoundOnTheCamerasHeightKeepsTheOwnFloor)
{
  FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = 1.0;
  expectFloor(detect(scene_, seed(), parameters), own_);
}

TEST_F(AtALedge, AFirmFloorGoesOnAboveTheDrop)
{
  FloorPrior prior;
  prior.up = own_.normal;
  prior.up_is_measured = true;
  prior.height = own_.distance;
  prior.height_tolerance = 0.06;
  prior.confirmed = true;
  const auto found = detect(scene_, prior);
  expectFloor(found, own_);
  ASSERT_EQ(std::distance(found->others.begin(), found->others.end()), 1);
  EXPECT_NEAR(*found->others.begin(), -1.2, 0.01);
}

/// A camera pitched down by 0.7 rad looks down a staircase: treads 28 cm deep, each 16 cm lower, from 0.9 m
/// ahead.
test::PlaneScene stairsDown(const geometry::Plane& own)
{
  const Eigen::Vector3d ahead(0.0, -std::sin(0.7), std::cos(0.7));
  test::PlaneScene scene(320, 240, 285.0, 0.002);
  for (int step = 0; step < 6; ++step) {
    scene.add(test::raised(own, -0.16 * step),
              [&](const Eigen::Vector3d& p) { return ahead.dot(p) < 0.9 + 0.28 * step; });
  }
  return scene;
}

TEST(FloorDetector, AStepThatTheCameraCouldStandOnIsNotTheFloorIfTheNextOneCannotBe)
{
  const geometry::Plane own = test::floorSeenFrom(1.2, 0.7);
  FloorDetector::Parameters parameters;
  for (const double known_to : {0.1, 0.25, 0.4}) {
    parameters.selection.max_camera_height = own.distance + known_to;
    const auto found = detect(stairsDown(own), seed(), parameters);
    ASSERT_TRUE(found) << "height known to " << known_to;
    EXPECT_NEAR(found->plane.distance, own.distance, 0.01) << "height known to " << known_to;
  }
}

TEST(FloorDetector, ABoxUponTheFloorIsNoStairHoweverDeepTheHoleBesideIt)
{
  // A pallet's top 14 cm above the floor, and a pit of 0.6 m beyond: their rises differ.
  const geometry::Plane own = test::floorSeenFrom(1.2, 0.7);
  test::PlaneScene scene(320, 240, 285.0, 0.002);
  scene.add(test::raised(own, -0.6));
  scene.add(own, [](const Eigen::Vector3d& p) { return p.z() < 1.7; });
  scene.add(test::raised(own, 0.14), [](const Eigen::Vector3d& p) { return p.z() < 1.2 && p.x() > 0.0; });
  FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = own.distance + 0.25;
  const auto found = detect(scene, seed(), parameters);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, own.distance, 0.01);
}

TEST(FloorDetector, WhatAShinyFloorMirrorsIsNoStepBelowIt)
{
  // A low shelf stands on the floor, which shows its mirror image as far below.
  constexpr double kHeight = 1.2;
  constexpr double kShelf = 0.14;
  const geometry::Plane own = test::floorSeenFrom(kHeight, 0.7);
  const Eigen::Vector3d ahead(0.0, -std::sin(0.7), std::cos(0.7));
  const auto in_shelf = [&](const Eigen::Vector3d& p) {
    return ahead.dot(p) > 0.9 && ahead.dot(p) < 1.7 && p.x() > -0.2 && p.x() < 0.8;
  };
  const double deeper = (kHeight + kShelf) / kHeight;  // where a ray through the floor meets the image
  test::PlaneScene scene(320, 240, 285.0, 0.002);
  scene.add(test::raised(own, -kShelf), in_shelf);
  scene.add(own, [&](const Eigen::Vector3d& p) { return !in_shelf(deeper * p); });
  scene.add(test::raised(own, kShelf), in_shelf);
  FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = kHeight + 0.1;
  const auto found = detect(scene, seed(), parameters);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, kHeight, 0.01);
}

/// A platform 0.6 m under the camera that fills the view, but for a few columns at its right edge where the
/// floor is seen 0.4 m lower: fewer than the samples lie apart.
class AtAStrip : public ::testing::Test
{
protected:
  AtAStrip()
  {
    scene_.add(floor_);
    scene_.add(platform_, [](const Eigen::Vector3d& p) { return p.x() < 76.0 / 142.5 * p.z(); });
  }

  geometry::Plane floor_ = test::floorSeenFrom(1.0, 0.7);
  geometry::Plane platform_ = test::raised(floor_, 0.4);
  test::PlaneScene scene_{160, 120, 142.5, 0.002};
};

TEST_F(AtAStrip, TheStripBelowThePlatformIsTheFloor)
{
  const auto found = detect(scene_);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, 1.0, 0.01) << "the platform is at 0.6 m";
  ASSERT_EQ(std::distance(found->others.begin(), found->others.end()), 1);
  EXPECT_NEAR(*found->others.begin(), 0.4, 0.01) << "the platform, above the floor";
}

TEST_F(AtAStrip, ThePlatformsSamplesAreNotTheFloors)
{
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene_.view());
  FloorDetector detector{FloorDetector::Parameters{}};
  const auto found = detector.detect(scene_.view(), grid, seed());
  ASSERT_TRUE(found);
  ASSERT_NEAR(found->plane.distance, 1.0, 0.01);
  std::uint32_t on_the_floor = 0;
  for (std::size_t k = 0; k < grid.samples().size(); ++k) {
    const Sample& sample = grid.samples()[k];
    if (!sample.has_point || detector.labels()[k] != SampleLabel::kFloor) continue;
    ++on_the_floor;
    EXPECT_NEAR(floor_.height(sample.point.cast<double>()), 0.0, 0.1)
        << "sample " << k << " is labelled floor";
  }
  EXPECT_EQ(found->sample_count, on_the_floor);
}

TEST_F(AtAStrip, TheStripContinuesTheFloorThatWasAtItsHeight)
{
  const auto continuedAfter = [&](double height) {
    FloorPrior prior;
    prior.up = platform_.normal;
    prior.up_is_measured = true;
    prior.height = height;
    prior.height_tolerance = 0.06;
    const auto found = detect(scene_, prior);
    EXPECT_TRUE(found && std::abs(found->plane.distance - 1.0) < 0.01);
    return found && found->continued;
  };
  EXPECT_TRUE(continuedAfter(floor_.distance));
  EXPECT_FALSE(continuedAfter(platform_.distance)) << "the last floor was the platform";
}

TEST_F(AtAStrip, AConfirmedFloorIsNoPlatform)
{
  FloorPrior prior;
  prior.up = platform_.normal;
  prior.up_is_measured = true;
  prior.height = platform_.distance;
  prior.height_tolerance = 0.06;
  prior.confirmed = true;
  const auto found = detect(scene_, prior);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, 0.6, 0.01) << "the strip is a drop beside it";
  EXPECT_TRUE(found->continued);
}

TEST_F(AtAStrip, AStripDeeperThanAFloorCanBeIsNone)
{
  FloorDetector::Parameters parameters;
  parameters.selection.max_camera_height = 0.9;
  const auto found = detect(scene_, seed(), parameters);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, 0.6, 0.01);
}

TEST(FloorDetector, AThresholdAcrossTheFloorDoesNotRaiseIt)
{
  // 2 cm high and half a metre deep; the floor goes on behind it.
  const geometry::Plane floor = test::floorSeenFrom(0.8, 0.5);
  test::PlaneScene scene(160, 120, 142.5, 0.002);
  scene.add(floor);
  scene.add(test::raised(floor, 0.02), [](const Eigen::Vector3d& p) { return p.z() > 1.2 && p.z() < 1.7; });
  const auto found = detect(scene);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->plane.distance, 0.8, 0.005);
}

TEST(FloorDetector, LabelsSayWhatBecameOfEachSample)
{
  const geometry::Plane floor = test::floorSeenFrom(1.0, 0.6);
  test::PlaneScene scene;
  // A floor, a box's top on the left, a wall 2.5 m ahead, nothing in the image's upper left corner.
  scene.add(floor);
  scene.add(test::raised(floor, 0.4), [](const Eigen::Vector3d& p) { return p.x() < -0.2 && p.z() < 1.0; });
  scene.add({-Eigen::Vector3d(0.0, std::sin(-0.6), std::cos(-0.6)), 2.5});
  for (std::size_t k = 0; k < scene.depth().size(); ++k) {
    if (k / 160 < 20 && k % 160 < 40) scene.depth()[k] = std::numeric_limits<float>::quiet_NaN();
  }
  SampleGrid grid{SampleGrid::Parameters{}};
  grid.update(scene.view());
  FloorDetector detector{FloorDetector::Parameters{}};
  ASSERT_TRUE(detector.detect(scene.view(), grid, seed()));
  const auto label = [&](std::size_t i, std::size_t j) { return detector.labels()[32 * j + i]; };
  EXPECT_EQ(label(1, 1), SampleLabel::kNoPoint);
  EXPECT_EQ(label(16, 1), SampleLabel::kPruned);
  EXPECT_EQ(label(3, 28), SampleLabel::kSegment);
  EXPECT_EQ(label(28, 28), SampleLabel::kFloor);
}

}  // namespace
}  // namespace polygonal_perception::perception
