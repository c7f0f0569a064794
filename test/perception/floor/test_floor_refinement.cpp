#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "perception/floor/floor_refinement.hpp"
#include "polygonal_perception/geometry/angle.hpp"
#include "support/plane_scene.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFloor = test::floorSeenFrom(1.0, 0.7);
const Eigen::Vector3d kUp = kFloor.normal;
const Eigen::Vector3d kForward(0.0, kUp.z(), -kUp.y());  // along the floor
constexpr double kDegree = 0.017453292519943295;

/// The plane that is turned about the camera's x axis, and lies higher.
geometry::Plane off(const geometry::Plane& plane, double angle, double offset)
{
  return {Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) * plane.normal, plane.distance - offset};
}

std::optional<FloorRefinement::Result> refined(const test::PlaneScene& scene, const geometry::Plane& rough,
                                               const std::vector<geometry::Plane>& rivals = {},
                                               const FloorRefinementParameters& parameters = {})
{
  FloorRefinement refinement;
  refinement.take(scene.view(), SensorNoise());
  return refinement.refine(rough, rivals, parameters);
}

void expectFloor(const std::optional<FloorRefinement::Result>& result)
{
  ASSERT_TRUE(result) << "no floor";
  EXPECT_LT(geometry::angleBetween(result->fit.plane.normal, kFloor.normal) / kDegree, 0.1);
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

/// Half of the view is a slab so high.
test::PlaneScene halfRaised(double height)
{
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  scene.add(test::raised(kFloor, height), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  return scene;
}

TEST(FloorRefinement, ARivalKeepsThePixelsThatLieNearerToIt)
{
  // A slab of 2 cm over half of the picture lies in the floor's band. Whoever knows it does not fit the floor
  // to it.
  const test::PlaneScene scene = halfRaised(0.02);
  const auto error = [&](const std::vector<geometry::Plane>& rivals) {
    const auto result = refined(scene, kFloor, rivals);
    return result ? std::abs(result->fit.plane.distance - kFloor.distance) +
                        geometry::angleBetween(result->fit.plane.normal, kFloor.normal)
                  : 1.0;
  };
  const double alone = error({});
  const double with_rival = error({test::raised(kFloor, 0.02)});
  EXPECT_LT(with_rival, 0.5 * alone) << "an error of " << with_rival << " with it and " << alone
                                     << " without";
  expectFloor(refined(scene, kFloor, {test::raised(kFloor, 0.02)}));
}

TEST(FloorRefinement, EachOfTwoRivalsKeepsItsOwn)
{
  // A slab on the left, and on the right a hollow.
  test::PlaneScene pit = noisyScene();
  pit.add(test::raised(kFloor, -0.02), [](const Eigen::Vector3d& p) { return p.x() > 0.25; });
  pit.add(kFloor, [](const Eigen::Vector3d& p) { return p.x() <= 0.25; });
  pit.add(test::raised(kFloor, 0.02), [](const Eigen::Vector3d& p) { return p.x() < -0.25; });
  expectFloor(refined(pit, kFloor, {test::raised(kFloor, 0.02), test::raised(kFloor, -0.02)}));
}

TEST(FloorRefinement, ARivalFarOffTakesNothing)
{
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  const auto alone = refined(scene, kFloor);
  const auto with_rival = refined(scene, kFloor, {test::raised(kFloor, 0.4)});
  ASSERT_TRUE(alone && with_rival);
  EXPECT_EQ(alone->fit.plane.distance, with_rival->fit.plane.distance);
  EXPECT_EQ(alone->fit.plane.normal, with_rival->fit.plane.normal);
}

TEST(FloorRefinement, TheFootOfAWallDoesNotTiltIt)
{
  test::PlaneScene scene = noisyScene();
  scene.add(kFloor);
  scene.add({-kForward, 1.2});
  expectFloor(refined(scene, kFloor));
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
  refinement.take(large.view(), SensorNoise());
  ASSERT_TRUE(refinement.refine(kFloor, {}, {}));
  for (const std::uint32_t width : {1U, 2U, 53U, 60U}) {
    const test::PlaneScene free(width, 3);
    refinement.take(free.view(), SensorNoise());
    EXPECT_FALSE(refinement.refine(kFloor, {}, {})) << "width " << width;
    EXPECT_FALSE(refinement.findStripBelow(kFloor, 3.0, {})) << "width " << width;
  }
}

/// A platform 0.6 m below the camera, beside which the floor is seen 0.4 m lower.
class Strip : public testing::Test
{
protected:
  std::optional<FloorRefinement::Result> found(double deepest = 3.0)
  {
    FloorRefinement refinement;
    refinement.take(scene_.view(), SensorNoise());
    return refinement.findStripBelow(platform_, deepest, FloorRefinementParameters{});
  }

  /// The floor, and the platform up to a column of the picture from which on the floor is seen.
  void addBoth(double columns_of_floor)
  {
    scene_.add(kFloor);
    const double edge = (159.0 - columns_of_floor - 79.5 + 0.5) / 142.5;
    scene_.add(platform_, [edge](const Eigen::Vector3d& p) { return p.x() < edge * p.z(); });
  }

  geometry::Plane platform_ = test::raised(kFloor, 0.4);
  test::PlaneScene scene_ = noisyScene();
};

TEST_F(Strip, ANarrowOneBesideAPlatformIsTheFloor)
{
  // 4 columns of 160: the samples lie 5 columns apart.
  addBoth(4);
  const auto strip = found();
  ASSERT_TRUE(strip) << "none found";
  EXPECT_NEAR(strip->fit.plane.distance, kFloor.distance, 0.01);
  EXPECT_LT(geometry::angleBetween(strip->fit.plane.normal, kFloor.normal) / kDegree, 0.5)
      << "it is parallel to the platform";
}

TEST_F(Strip, OneLittleLowerIsNotFittedToThePlatformsFarPixels)
{
  // 3 cm: so far away that the noise allows it, the platform's own pixels lie in the strip's band.
  scene_.add(test::raised(platform_, -0.03));
  scene_.add(platform_, [](const Eigen::Vector3d& p) { return p.x() < 72.5 / 142.5 * p.z(); });
  const auto strip = found();
  ASSERT_TRUE(strip) << "none found";
  EXPECT_NEAR(strip->fit.plane.distance, 0.63, 0.002) << "the platform is at 0.6 m";
}

TEST_F(Strip, TakesTheTiltOfThePlatformAcross)
{
  // What is seen of the floor leans to the side by 2 degrees, which 4 columns cannot tell.
  const geometry::Plane leaning{Eigen::AngleAxisd(2 * kDegree, kForward) * kFloor.normal, kFloor.distance};
  scene_.add(leaning);
  scene_.add(platform_, [](const Eigen::Vector3d& p) { return p.x() < 75.5 / 142.5 * p.z(); });
  const auto strip = found();
  ASSERT_TRUE(strip) << "none found";
  const double across = std::asin(strip->fit.plane.normal.x()) / kDegree;
  EXPECT_NEAR(across, 0.0, 0.7) << "the strip's own tilt is 2 degrees";
}

TEST_F(Strip, ThePlatformAloneHasNoneBelow)
{
  scene_.add(platform_);
  const auto strip = found();
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance;
}

TEST_F(Strip, AFewPixelsAreNone)
{
  // 8 rows of 4 columns: 0.2 per cent.
  scene_.add(platform_);
  test::PlaneScene below = noisyScene();
  below.add(kFloor);
  for (std::size_t v = 60; v < 68; ++v) {
    for (std::size_t u = 100; u < 104; ++u) scene_.depth()[160 * v + u] = below.depth()[160 * v + u];
  }
  const auto strip = found();
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance;
}

TEST_F(Strip, ScatterIsNone)
{
  // As many pixels, at any depth between the platform and 3 m.
  scene_.add(platform_);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> deeper(1.05F, 4.0F);
  for (std::size_t v = 0; v < 120; ++v) {
    for (std::size_t u = 154; u < 160; ++u) scene_.depth()[160 * v + u] *= deeper(random);
  }
  const auto strip = found();
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance;
}

TEST_F(Strip, ThingsAtManyHeightsAreNoneHoweverManyPixelsTheyHaveTogether)
{
  // Six columns at the side of the picture, every ten rows of which lie 10 cm deeper than the ten before. One
  // such piece has too few pixels for a strip, twelve have enough.
  scene_.add(platform_);
  for (std::size_t piece = 0; piece < 12; ++piece) {
    test::PlaneScene below = noisyScene();
    below.add(test::raised(platform_, -0.1 - 0.1 * static_cast<double>(piece)));
    for (std::size_t v = 10 * piece; v < 10 * piece + 10; ++v) {
      for (std::size_t u = 154; u < 160; ++u) scene_.depth()[160 * v + u] = below.depth()[160 * v + u];
    }
  }
  const auto strip = found();
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance;
}

TEST_F(Strip, ABentFringeIsNone)
{
  // The right quarter of the platform sinks away gently, so deep at the picture's edge.
  for (const float sag : {0.02F, 0.04F, 0.06F, 0.1F, 0.15F}) {
    scene_ = noisyScene();
    scene_.add(platform_);
    for (std::size_t v = 0; v < 120; ++v) {
      for (std::size_t u = 120; u < 160; ++u) {
        const auto out = static_cast<float>(u - 120) / 40.0F;
        scene_.depth()[160 * v + u] *= 1.0F + sag / static_cast<float>(platform_.distance) * out * out;
      }
    }
    const auto strip = found();
    EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance << " below a platform at "
                        << platform_.distance << " that sinks by " << sag;
  }
}

TEST_F(Strip, ABentFringeDoesNotHideOne)
{
  addBoth(4);
  for (std::size_t v = 0; v < 120; ++v) {
    for (std::size_t u = 0; u < 20; ++u)
      scene_.depth()[160 * v + u] *= 1.0F + 0.002F * static_cast<float>(20 - u);
  }
  const auto strip = found();
  ASSERT_TRUE(strip) << "none found";
  EXPECT_NEAR(strip->fit.plane.distance, kFloor.distance, 0.01);
}

TEST_F(Strip, OneDeeperThanAFloorCanBeIsNone)
{
  addBoth(4);
  const auto strip = found(0.9);
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance << ", 0.9 m at most allowed";
  EXPECT_TRUE(found(1.1));
}

TEST_F(Strip, AWallBelowThePlatformsEdgeIsNone)
{
  // A riser that leads down from the platform's front edge: it runs across, not along.
  scene_.add({-kForward, 1.4}, [this](const Eigen::Vector3d& p) { return platform_.height(p) < 0.0; });
  scene_.add(platform_, [](const Eigen::Vector3d& p) { return kForward.dot(p) < 1.0; });
  const auto strip = found();
  EXPECT_FALSE(strip) << "found one at " << strip->fit.plane.distance;
}

}  // namespace
}  // namespace polygonal_perception::perception
