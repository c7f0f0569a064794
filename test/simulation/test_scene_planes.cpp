#include <gtest/gtest.h>

#include <algorithm>

#include "polygonal_perception/cameras/simulation/ray_caster.hpp"
#include "polygonal_perception/cameras/simulation/scene_planes.hpp"

namespace polygonal_perception::simulation {
namespace {

Eigen::Isometry3d at(double x, double y, double z)
{
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

TEST(ScenePlanes, ABoxHasSixOfTwoTrianglesEach)
{
  const ScenePlanes planes({makeBox(at(1.0, 2.0, 3.0), {0.5, 1.0, 2.0})});
  ASSERT_EQ(planes.ofTriangles().size(), 12U);
  EXPECT_EQ(planes.count(), 6U);
  for (std::uint16_t number = 1; number <= planes.count(); ++number) {
    EXPECT_EQ(std::count(planes.ofTriangles().begin(), planes.ofTriangles().end(), number), 2)
        << "plane " << number;
  }
}

TEST(ScenePlanes, FacesInOnePlaneHaveOneNumber)
{
  // Side by side: fronts, backs, bottoms and tops fall together, and so do the sides that touch.
  const ScenePlanes planes(
      {makeBox(at(0.0, 0.0, 0.5), {1.0, 1.0, 1.0}), makeBox(at(1.0, 0.0, 0.5), {1.0, 1.0, 1.0})});
  EXPECT_EQ(planes.count(), 7U);
  EXPECT_EQ(planes.ofTriangles()[0], planes.ofTriangles()[12]);
}

TEST(ScenePlanes, WhatIsCurvedLiesOnNone)
{
  const ScenePlanes planes(
      {makeFrustum({0, 0, 0}, {0, 0, 1}, 0.1, 0.1), makeEllipsoid(at(0, 0, 2), {1, 1, 1})});
  EXPECT_EQ(planes.count(), 0U);
  EXPECT_TRUE(std::all_of(planes.ofTriangles().begin(), planes.ofTriangles().end(),
                          [](std::uint16_t number) { return number == ScenePlanes::kNone; }));
}

TEST(ScenePlanes, ARayTellsThePlaneThatItMeets)
{
  Scene scene;
  scene.solids = {makeLevelRectangle({-5.0, -5.0}, {5.0, 5.0}, 0.0),
                  makeBox(at(0.0, 0.0, 0.25), {1.0, 1.0, 0.5})};
  RayCaster caster(scene);
  PinholeCamera camera;
  camera.width = 65;
  camera.height = 65;
  camera.fx = camera.fy = 32.0;
  camera.cx = camera.cy = 32.0;
  // From 2.5 m above, straight down: the box's top in the middle, the floor around it.
  Eigen::Isometry3d pose = at(0.0, 0.0, 2.5);
  pose.linear() = Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitX()).toRotationMatrix();
  RayImage image;
  caster.cast(camera, pose, 0.0, image);
  const std::uint16_t middle = image.plane[32 * 65 + 32];
  const std::uint16_t corner = image.plane[0];
  ASSERT_NE(middle, ScenePlanes::kNone);
  ASSERT_NE(corner, ScenePlanes::kNone);
  EXPECT_NEAR(std::abs(caster.planes().plane(middle).distance), 0.5, 1e-6) << "the box's top";
  EXPECT_NEAR(std::abs(caster.planes().plane(corner).distance), 0.0, 1e-6) << "the floor";
}

}  // namespace
}  // namespace polygonal_perception::simulation
