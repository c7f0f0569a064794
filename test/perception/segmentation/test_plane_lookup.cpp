#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "extracted_scene.hpp"

namespace polygonal_perception::perception {
namespace {

using test::ExtractedScene;
using test::wallAt;

constexpr int kNone = PlaneLookup::kNone;

/// A wall 1 m away on the left, and one that stands `step` behind it on the right; they meet in the image's middle.
struct TwoWalls : ExtractedScene
{
  explicit TwoWalls(double step) : ExtractedScene(scene(step)) {}

  static test::PlaneScene scene(double step)
  {
    test::PlaneScene scene;
    scene.add(wallAt(1.0), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
    scene.add(wallAt(1.0 + step), [](const Eigen::Vector3d& p) { return p.x() >= 0.0; });
    return scene;
  }

  int planeAt(int i, int j) const { return pieces.planeOf()[sampleAt(i, j)]; }
  int left() const { return planeAt(4, 16); }
  int right() const { return planeAt(27, 16); }
  /// A point straight ahead, held against the planes about a sample.
  PlaneLookup::Answer ahead(float z, int i) const
  {
    return lookup.planeOf(sampleAt(i, 16), Eigen::Vector3f(0.0F, 0.0F, z));
  }
};

/// [m] Standard deviation of the depth of a point straight ahead, as the parameters have it.
double sigmaAt(double z)
{
  const double noise = SensorNoise{}.at(static_cast<float>(z));
  const PlaneExtractionParameters parameters;
  return std::hypot(noise, parameters.model_error + parameters.model_error_slope * z);
}

TEST(PlaneLookup, APointOnAPlaneIsOnIt)
{
  const TwoWalls walls(0.2);
  ASSERT_NE(walls.left(), walls.right());
  const auto answer = walls.ahead(1.0F, 4);
  EXPECT_EQ(answer.plane, walls.left());
  EXPECT_TRUE(answer.is_on_own);
  EXPECT_EQ(walls.ahead(1.2F, 27).plane, walls.right());
}

TEST(PlaneLookup, TheVarianceIsThatOfTheSensor)
{
  const TwoWalls walls(0.2);
  EXPECT_NEAR(std::sqrt(walls.ahead(1.0F, 4).variance), sigmaAt(1.0), 1e-6);
  EXPECT_NEAR(std::sqrt(walls.ahead(1.2F, 27).variance), sigmaAt(1.2), 1e-6);
}

TEST(PlaneLookup, APlaneReachesAsFarAsTheInliersDo)
{
  const TwoWalls walls(0.2);
  const double reach = PlaneExtractionParameters{}.inlier_sigmas * sigmaAt(1.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_EQ(walls.ahead(static_cast<float>(1.0 + 0.9 * side * reach), 4).plane, walls.left())
        << 0.9 * side * reach << " m behind it";
    const auto beyond = walls.ahead(static_cast<float>(1.0 + 1.1 * side * reach), 4);
    EXPECT_EQ(beyond.plane, kNone) << 1.1 * side * reach << " m behind it";
    EXPECT_FALSE(beyond.is_on_own);
  }
}

TEST(PlaneLookup, OnlyPlanesOfTheSamplesAroundComeIntoQuestion)
{
  const TwoWalls walls(0.2);
  // The walls meet between the samples 15 and 16.
  EXPECT_EQ(walls.ahead(1.2F, 14).plane, kNone) << "two samples from the wall at 1.2 m";
  EXPECT_EQ(walls.ahead(1.2F, 15).plane, walls.right()) << "beside it";
  EXPECT_EQ(walls.ahead(1.0F, 16).plane, walls.left()) << "beside the wall at 1 m";
  EXPECT_EQ(walls.ahead(1.0F, 17).plane, kNone) << "two samples from it";
}

TEST(PlaneLookup, ADiagonalNeighbourIsASampleAroundToo)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  paint(scene, test::around(10, 20, 10, 20), 0.8F);
  const ExtractedScene seen(scene);
  const int panel = seen.pieces.planeOf()[seen.sampleAt(15, 15)];
  const Eigen::Vector3f point(0.0F, 0.0F, 0.8F);
  ASSERT_NE(panel, kNone);
  EXPECT_EQ(seen.lookup.planeOf(seen.sampleAt(9, 9), point).plane, panel);
  EXPECT_EQ(seen.lookup.planeOf(seen.sampleAt(8, 9), point).plane, kNone);
}

TEST(PlaneLookup, OfTwoPlanesTheNearerHasThePoint)
{
  // Of 2 cm the middle is in reach of both.
  const TwoWalls walls(0.02);
  ASSERT_NE(walls.left(), walls.right());
  EXPECT_EQ(walls.ahead(1.008F, 15).plane, walls.left());
  EXPECT_EQ(walls.ahead(1.013F, 15).plane, walls.right());
  EXPECT_EQ(walls.ahead(1.008F, 16).plane, walls.left()) << "whichever the sample is of";
  EXPECT_EQ(walls.ahead(1.013F, 16).plane, walls.right());
}

TEST(PlaneLookup, APointMayLieOnTheSamplesPlaneAndNearerToAnother)
{
  const TwoWalls walls(0.02);
  const auto answer = walls.ahead(1.013F, 15);
  EXPECT_EQ(answer.plane, walls.right());
  EXPECT_TRUE(answer.is_on_own) << "1.3 cm, less than the reach of the wall at 1 m";
  EXPECT_FALSE(walls.ahead(1.02F, 15).is_on_own) << "2 cm is more";
}

TEST(PlaneLookup, WhatIsNoPointIsOnNoPlane)
{
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const TwoWalls walls(0.2);
  for (const Eigen::Vector3f& point :
       {Eigen::Vector3f(test::kNoReturn, test::kNoReturn, test::kNoReturn),
        Eigen::Vector3f(0.0F, test::kNoReturn, 1.0F), Eigen::Vector3f(0.0F, 0.0F, kInfinity),
        Eigen::Vector3f(-kInfinity, 0.0F, 1.0F), Eigen::Vector3f(0.0F, 0.0F, 0.0F)}) {
    const auto answer = walls.lookup.planeOf(walls.sampleAt(4, 16), point);
    EXPECT_EQ(answer.plane, kNone) << point.transpose();
    EXPECT_FALSE(answer.is_on_own) << point.transpose();
  }
}

TEST(PlaneLookup, ASampleIsSettledWhereNoOtherPlaneIsAround)
{
  const TwoWalls walls(0.2);
  const auto left = static_cast<std::size_t>(walls.left());
  const auto right = static_cast<std::size_t>(walls.right());
  const auto is_settled = [&](int i, std::optional<std::size_t> plane) {
    return walls.lookup.isSettled(walls.sampleAt(i, 16), plane);
  };
  EXPECT_TRUE(is_settled(4, left));
  EXPECT_FALSE(is_settled(4, right));
  EXPECT_FALSE(is_settled(4, {})) << "no plane is known";
  EXPECT_FALSE(is_settled(15, left)) << "both are around";
  EXPECT_FALSE(is_settled(16, right)) << "both are around";
  EXPECT_TRUE(is_settled(27, right));
  const ExtractedScene empty{test::PlaneScene()};
  EXPECT_TRUE(empty.lookup.isSettled(0, {})) << "no plane at all";
}

TEST(PlaneLookup, ABetterFitReplacesAPlane)
{
  TwoWalls walls(0.2);
  ASSERT_EQ(walls.lookup.size(), 2U);
  walls.lookup.set(static_cast<std::size_t>(walls.left()), wallAt(1.1));
  EXPECT_EQ(walls.ahead(1.1F, 4).plane, walls.left());
  EXPECT_EQ(walls.ahead(1.0F, 4).plane, kNone);
  EXPECT_EQ(walls.ahead(1.2F, 27).plane, walls.right()) << "the other stays";
  EXPECT_EQ(walls.lookup.size(), 2U);
}

TEST(PlaneLookup, NothingOfTheLastFrameIsLeft)
{
  TwoWalls walls(0.2);
  const ExtractedScene empty{test::PlaneScene()};
  walls.lookup.take(empty.extraction, empty.pieces.planeOf(), empty.parameters);
  EXPECT_EQ(walls.lookup.size(), 0U);
  EXPECT_EQ(walls.ahead(1.0F, 4).plane, kNone);
}

}  // namespace
}  // namespace polygonal_perception::perception
