#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perception/floor/floor_choice.hpp"
#include "perception/floor/floor_refinement.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFloor = test::floorSeenFrom(1.0, 0.7);
const Eigen::Vector3d kUp = kFloor.normal;
const Eigen::Vector3d kForward(0.0, kUp.z(), -kUp.y());  // along the floor
constexpr double kDegree = M_PI / 180.0;

/// The plane that is turned about the camera's x axis, and lies higher.
geometry::Plane off(const geometry::Plane& plane, double angle, double offset)
{
  return {Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) * plane.normal, plane.distance - offset};
}

std::optional<FloorRefinement::Result> refined(const test::PlaneScene& scene, const geometry::Plane& rough)
{
  FloorRefinement refinement;
  refinement.take(scene.view());
  return refinement.refine(rough, FloorDetector::Parameters{});
}

void expectFloor(const std::optional<FloorRefinement::Result>& result)
{
  ASSERT_TRUE(result) << "no floor";
  EXPECT_LT(angleBetween(result->fit.plane.normal, kFloor.normal) / kDegree, 0.1);
  EXPECT_NEAR(result->fit.plane.distance, kFloor.distance, 0.002);
}

/// A scene with the noise of a camera.
test::PlaneScene noisyScene()
{
  return test::PlaneScene(160, 120, 142.5, 0.003);
}

TEST(FloorRefinement, TurnsARoughPlaneIntoTheFloor)
{
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  expectFloor(refined(scene, kFloor));
  expectFloor(refined(scene, off(kFloor, 1.0 * kDegree, 0.0)));
  expectFloor(refined(scene, off(kFloor, 0.0, 0.015)));
}

TEST(FloorRefinement, WhatStandsLowOnTheFloorDoesNotTiltIt)
{
  // A slab of 2.5 cm, such as the foot of a lamp, over a seventh of the picture.
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  scene.add(test::raised(kFloor, 0.025), [](const Eigen::Vector3d& p) { return p.x() < -0.25; });
  expectFloor(refined(scene, kFloor));
}

TEST(FloorRefinement, TheFootOfAWallDoesNotTiltIt)
{
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  scene.add({-kForward, 1.2});
  expectFloor(refined(scene, kFloor));
}

TEST(FloorRefinement, CountsWhatLiesBelow)
{
  test::PlaneScene scene;
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return p.x() > 0.0; });
  scene.add(test::raised(kFloor, -0.4), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  const auto result = refined(scene, kFloor);
  ASSERT_TRUE(result);
  EXPECT_GT(result->counts.inliers, 2000);
  EXPECT_GT(result->counts.below, 2000);
}

TEST(FloorRefinement, ThePlaneAlongTheNosesOfStairsIsNone)
{
  // The surface meets that plane at every nose, and runs along it nowhere. The rows are far enough apart for
  // the steps between them to stand out of the noise that a camera has.
  constexpr double kStart = 0.4;
  constexpr double kTread = 0.28;
  constexpr double kRise = 0.17;
  test::PlaneScene scene(80, 60, 71.0);
  for (int n = 0; n < 8; ++n) {
    const double edge = kStart + n * kTread;
    scene.add({-kForward, edge}, [n](const Eigen::Vector3d& p) {
      return kFloor.height(p) > n * kRise && kFloor.height(p) < (n + 1) * kRise;
    });
    scene.add(test::raised(kFloor, (n + 1) * kRise), [edge](const Eigen::Vector3d& p) {
      return kForward.dot(p) > edge && kForward.dot(p) < edge + kTread;
    });
  }
  const Eigen::Vector3d normal = (kTread * kUp - kRise * kForward).normalized();
  const Eigen::Vector3d first_nose = kStart * kForward + (kRise - kFloor.distance) * kUp;
  EXPECT_FALSE(refined(scene, {normal, -normal.dot(first_nose)}));
}

TEST(FloorRefinement, AFewPixelsAreNone)
{
  test::PlaneScene scene;
  scene.add(kFloor, [](const Eigen::Vector3d& p) { return p.head<2>().norm() < 0.05; });
  EXPECT_FALSE(refined(scene, kFloor));
}

TEST(FloorRefinement, AStripIsTooNarrowForANormal)
{
  const auto stripOf = [](double width) {
    test::PlaneScene scene(160, 120, 142.5, 0.01);
    scene.add(kFloor, [width](const Eigen::Vector3d& p) { return std::abs(p.x()) < 0.5 * width; });
    return refined(scene, kFloor);
  };
  EXPECT_TRUE(stripOf(0.5));
  EXPECT_FALSE(stripOf(0.06)) << "it has a normal, but an uncertain one";
  EXPECT_FALSE(stripOf(0.04)) << "it has none";
}

TEST(FloorRefinement, NothingIsNone)
{
  EXPECT_FALSE(refined(test::PlaneScene(), kFloor));
  test::PlaneScene elsewhere;
  elsewhere.add(kFloor);
  EXPECT_FALSE(refined(elsewhere, test::raised(kFloor, 0.5)));
}

TEST(FloorRefinement, ForgetsTheLastFrame)
{
  test::PlaneScene large(320, 240, 285.0);
  large.add(kFloor);
  FloorRefinement refinement;
  refinement.take(large.view());
  ASSERT_TRUE(refinement.refine(kFloor, FloorDetector::Parameters{}));
  for (const std::uint32_t width : {1U, 2U, 53U, 60U}) {
    const test::PlaneScene free(width, 3);
    refinement.take(free.view());
    EXPECT_FALSE(refinement.refine(kFloor, FloorDetector::Parameters{})) << "width " << width;
  }
}

}  // namespace
}  // namespace polygonal_perception::perception
