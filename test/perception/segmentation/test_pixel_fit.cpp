#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "extracted_scene.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {
namespace {

using test::ExtractedScene;
using test::wallAt;

constexpr double kDegree = 0.017453292519943295;
constexpr double kNoiseAt2m = 0.006;  // [m] of an Xtion

/// The planes of a scene after the fit through its pixels.
struct FittedScene : ExtractedScene
{
  explicit FittedScene(const test::PlaneScene& scene, const std::optional<std::size_t>& known = {})
      : ExtractedScene(scene)
  {
    fit.fit(scene.view(), extraction, pieces.planeOf(), known, 1024, lookup);
  }

  /// The plane of a sample.
  std::size_t planeAt(int i, int j) const
  {
    return static_cast<std::size_t>(pieces.planeOf()[sampleAt(i, j)]);
  }

  PixelFit fit;
};

/// Some plane 2 m away, another one for each k.
geometry::Plane tilted(int k)
{
  return {Eigen::Vector3d(0.03 * (k % 5) - 0.06, 0.05 * (k % 7) - 0.15, -1.0).normalized(), 2.0};
}

TEST(PixelFit, PixelsTellANoisyPlaneBetterThanSamples)
{
  double by_samples = 0.0;
  double by_pixels = 0.0;
  for (int k = 0; k < 20; ++k) {
    test::PlaneScene scene(160, 120, test::kFocalLength, kNoiseAt2m);
    scene.add(tilted(k));
    const FittedScene seen(scene);
    ASSERT_EQ(seen.extraction.planes().size(), 1U) << "plane " << k;
    const PlaneFit::Result& fit = seen.fit[0].plane;
    by_samples += geometry::angleBetween(seen.extraction.planes()[0].fit.plane.normal, tilted(k).normal);
    by_pixels += geometry::angleBetween(fit.plane.normal, tilted(k).normal);
    EXPECT_NEAR(fit.plane.distance, 2.0, 0.002) << "plane " << k;
    EXPECT_NEAR(fit.rms_error, kNoiseAt2m, 0.001) << "plane " << k;
    EXPECT_LT(fit.normal_sigma, 0.7 * seen.extraction.planes()[0].fit.normal_sigma) << "plane " << k;
    EXPECT_GT(seen.fit[0].support, 0.95) << "plane " << k;
  }
  EXPECT_LT(by_pixels, 0.7 * by_samples) << "sums of 20 angles [rad]";
}

TEST(PixelFit, TheErrorIsWhatTheCovarianceSays)
{
  double squares = 0.0;
  for (int k = 0; k < 35; ++k) {
    test::PlaneScene scene(160, 120, test::kFocalLength, kNoiseAt2m);
    scene.add(tilted(k));
    const FittedScene seen(scene);
    ASSERT_EQ(seen.extraction.planes().size(), 1U) << "plane " << k;
    const Eigen::Matrix4d& covariance = seen.fit[0].covariance;
    EXPECT_TRUE(covariance.isApprox(covariance.transpose())) << covariance;
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(covariance).eigenvalues()[0], -1e-12)
        << covariance;
    const double error = seen.fit[0].plane.plane.distance - 2.0;
    squares += error * error / covariance(3, 3);
    EXPECT_LT(std::abs(error), 4.0 * std::sqrt(covariance(3, 3))) << "plane " << k;
  }
  EXPECT_GT(squares, 0.0);
  EXPECT_LT(squares / 35.0, 2.0) << "of errors over standard deviations, the mean square";
}

TEST(PixelFit, OfTwoWallsNeitherTakesTheOthersPixels)
{
  test::PlaneScene scene(160, 120, test::kFocalLength, 0.0019);
  scene.add(wallAt(1.0), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  scene.add(wallAt(1.03), [](const Eigen::Vector3d& p) { return p.x() >= 0.0; });
  const FittedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 2U);
  const PlaneFit::Result& left = seen.fit[seen.planeAt(4, 16)].plane;
  const PlaneFit::Result& right = seen.fit[seen.planeAt(27, 16)].plane;
  EXPECT_NEAR(left.plane.distance, 1.0, 0.001);
  EXPECT_NEAR(right.plane.distance, 1.03, 0.001);
  for (const PlaneFit::Result* fit : {&left, &right})
    EXPECT_LT(geometry::angleBetween(fit->plane.normal, wallAt(1.0).normal), 0.1 * kDegree);
}

TEST(PixelFit, TheLookupKnowsThePlanesByTheirPixelsAfterIt)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  FittedScene seen(scene);
  const auto answers = [&](float z) {
    return seen.lookup.planeOf(seen.sampleAt(16, 16), Eigen::Vector3f(0.0F, 0.0F, z)).plane;
  };
  // Somebody says that the wall is 1 cm farther; its pixels tell better.
  seen.lookup.set(0, wallAt(1.01));
  ASSERT_EQ(answers(0.99F), PlaneLookup::kNone);
  seen.fit.fit(scene.view(), seen.extraction, seen.pieces.planeOf(), {}, 1024, seen.lookup);
  EXPECT_EQ(answers(0.99F), 0);
  EXPECT_NEAR(seen.fit[0].plane.plane.distance, 1.0, 1e-5);
}

TEST(PixelFit, AKnownPlaneStaysWhatItIs)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  FittedScene seen(scene);
  seen.lookup.set(0, wallAt(1.01));
  seen.fit.fit(scene.view(), seen.extraction, seen.pieces.planeOf(), std::size_t{0}, 1024, seen.lookup);
  const auto answers = [&](float z) {
    return seen.lookup.planeOf(seen.sampleAt(16, 16), Eigen::Vector3f(0.0F, 0.0F, z)).plane;
  };
  EXPECT_EQ(answers(1.02F), 0);
  EXPECT_EQ(answers(0.99F), PlaneLookup::kNone) << "where it would be if it were fitted";
}

TEST(PixelFit, WhatIsKnownLeavesTheOtherPlanesTheirFit)
{
  test::PlaneScene scene(160, 120, test::kFocalLength, 0.0019);
  scene.add(wallAt(1.0), [](const Eigen::Vector3d& p) { return p.x() < 0.0; });
  scene.add(wallAt(1.2), [](const Eigen::Vector3d& p) { return p.x() >= 0.0; });
  const FittedScene without(scene);
  ASSERT_EQ(without.extraction.planes().size(), 2U);
  const std::size_t right = without.planeAt(27, 16);
  const FittedScene with(scene, without.planeAt(4, 16));
  EXPECT_NEAR(with.fit[right].plane.plane.distance, 1.2, 0.001);
  EXPECT_TRUE(with.fit[right].plane.plane.normal.isApprox(without.fit[right].plane.plane.normal, 1e-3))
      << with.fit[right].plane.plane.normal.transpose() << ", and if the other is not known "
      << without.fit[right].plane.plane.normal.transpose();
  EXPECT_GT(with.fit[right].support, 0.95);
}

TEST(PixelFit, WithoutPixelsThePlaneOfTheSamplesStays)
{
  // Samples take the next column where their own has no return; every other one is empty, and the fit looks at those.
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  for (std::size_t k = 1; k < scene.depth().size(); k += 2) scene.depth()[k] = test::kNoReturn;
  const FittedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 1U);
  EXPECT_EQ(seen.fit[0].support, 0.0);
  EXPECT_TRUE(seen.fit[0].covariance.isZero(0.0)) << seen.fit[0].covariance;
  EXPECT_EQ(seen.fit[0].plane.plane.distance, seen.extraction.planes()[0].fit.plane.distance);
  EXPECT_EQ(seen.fit[0].plane.plane.normal, seen.extraction.planes()[0].fit.plane.normal);
}

TEST(PixelFit, TheSupportIsTheShareOfPixelsThatLieOnThePlane)
{
  // Between the samples three of four rows of the wall's left half are 10 cm deeper.
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  std::vector<bool> has_samples(120);
  for (int j = 0; j < 32; ++j) has_samples[static_cast<std::size_t>(test::rowOf(j))] = true;
  for (int v = 0; v < 120; ++v) {
    if (!has_samples[static_cast<std::size_t>(v)]) paint(scene, {0, 159, v, v}, 1.1F);
  }
  const FittedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 1U);
  EXPECT_NEAR(seen.fit[0].support, 32.0 / 120.0, 0.01) << "every row is looked at, and 32 of 120 are on it";
  EXPECT_NEAR(seen.fit[0].plane.plane.distance, 1.0, 1e-4) << "what is not on it has no say";
}

TEST(PixelFit, ThePixelsOfAThinPoleDoNotLieOnThePlanesOfItsSamples)
{
  test::PlaneScene scene = test::poleAt(1.5, 0.03);
  scene.add(wallAt(2.5));
  const FittedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 2U) << "the wall, and two columns of samples";
  const std::size_t pole = seen.extraction.planes()[0].size < seen.extraction.planes()[1].size ? 0 : 1;
  EXPECT_LT(seen.fit[pole].support, 0.7);
}

TEST(PixelFit, APlaneAStepBesideDoesNotPull)
{
  // 8 mm beside the wall is within the model's error, 1 m away, but no noise.
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  const std::vector<float> wall = scene.depth();
  for (std::size_t k = 0; k < wall.size(); k += 2) {
    if (k / 160 % 4 == 0) scene.depth()[k] = 1.008F;
  }
  const FittedScene seen(scene);
  ASSERT_GE(seen.extraction.planes().size(), 1U);
  EXPECT_NEAR(seen.fit[0].plane.plane.distance, 1.0, 5e-4);
}

TEST(PixelFit, AWallDoesNotBendAndAPoleDoes)
{
  test::PlaneScene wall;
  wall.add(wallAt(1.0));
  EXPECT_LT(FittedScene(wall).fit[0].bend.curvature, 0.05);
  test::PlaneScene pole = test::poleAt(0.8, 0.06);
  const FittedScene seen(pole);
  ASSERT_GE(seen.extraction.planes().size(), 1U);
  for (std::size_t k = 0; k < seen.extraction.planes().size(); ++k)
    EXPECT_GT(seen.fit[k].bend.curvature, 2.0) << "plane " << k;
}

TEST(PixelFit, LargePlanesAreNotLookedAtForCurvature)
{
  const test::PlaneScene pole = test::poleAt(0.8, 0.06);
  FittedScene seen(pole);
  ASSERT_GE(seen.extraction.planes().size(), 1U);
  seen.fit.fit(pole.view(), seen.extraction, seen.pieces.planeOf(), {}, 5, seen.lookup);
  EXPECT_EQ(seen.fit[0].bend.curvature, 0.0) << "of more than five samples";
}

TEST(PixelFit, AnImageSmallerThanTheGridIsFitted)
{
  test::PlaneScene scene(20, 15, 18.0);
  scene.add(wallAt(1.0));
  const FittedScene seen(scene);
  ASSERT_EQ(seen.extraction.planes().size(), 1U);
  EXPECT_NEAR(seen.fit[0].plane.plane.distance, 1.0, 1e-5);
  EXPECT_EQ(seen.fit[0].support, 1.0);
}

TEST(PixelFit, OfNoPlanesThereIsNoFit)
{
  test::PlaneScene scene;
  scene.add(wallAt(1.0));
  FittedScene seen(scene);
  const ExtractedScene empty{test::PlaneScene()};
  seen.lookup.take(empty.extraction, empty.pieces.planeOf(), empty.parameters);
  seen.fit.fit(test::PlaneScene().view(), empty.extraction, empty.pieces.planeOf(), {}, 1024, seen.lookup);
  EXPECT_EQ(seen.lookup.size(), 0U);
}

}  // namespace
}  // namespace polygonal_perception::perception
