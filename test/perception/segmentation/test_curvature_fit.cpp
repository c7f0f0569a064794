#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "perception/segmentation/curvature_fit.hpp"

namespace polygonal_perception::perception {
namespace {

const geometry::Plane kFacing{-Eigen::Vector3d::UnitZ(), 1.0};
const Eigen::Vector3d kCentre(0.1, -0.05, 1.0);

/// 15 x 15 points of a patch of the surface z = 1 + depth(x, y), x and y from its middle.
/// @param noise  [m] standard deviation along z
CurvatureFit::Result fitted(const std::function<double(double, double)>& depth, double width, double height,
                            double noise = 0.0, std::uint32_t seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0.0, 1.0);
  CurvatureFit fit(kFacing, kCentre);
  for (int i = -7; i <= 7; ++i) {
    for (int j = -7; j <= 7; ++j) {
      const double x = width * i / 14.0;
      const double y = height * j / 14.0;
      const Eigen::Vector3d point = kCentre + Eigen::Vector3d(x, y, depth(x, y) + noise * error(random));
      fit.add(point.cast<float>(), 1e5F);
    }
  }
  return fit.solve();
}

TEST(CurvatureFit, APlaneDoesNotBend)
{
  const auto result = fitted([](double x, double y) { return 0.1 * x - 0.2 * y; }, 0.1, 0.3);
  EXPECT_NEAR(result.curvature, 0.0, 0.01) << "tilted against the plane that it was told";
  EXPECT_LT(result.sigma, 0.1);
}

TEST(CurvatureFit, ACylinderBendsByOneOverItsRadiusWhicheverWayItLies)
{
  for (const double turn : {0.0, 0.4, 0.9, 1.6, 2.5}) {
    const auto depth = [turn](double x, double y) {
      const double across = std::cos(turn) * x + std::sin(turn) * y;
      return 0.25 - std::sqrt(0.25 * 0.25 - across * across);
    };
    const auto result = fitted(depth, 0.1, 0.1);
    EXPECT_NEAR(result.curvature, 4.0, 0.1) << "turned by " << turn << " rad";
  }
}

TEST(CurvatureFit, AHollowBendsAsMuchAsABulge)
{
  const auto hollow = [](double x, double) { return -2.0 * x * x; };
  EXPECT_NEAR(fitted(hollow, 0.1, 0.1).curvature, 4.0, 0.01);
}

TEST(CurvatureFit, OfTwoCurvaturesTheLargerIsGiven)
{
  const auto saddle = [](double x, double y) { return 1.5 * x * x - 4.0 * y * y; };
  EXPECT_NEAR(fitted(saddle, 0.1, 0.1).curvature, 8.0, 0.02);
}

TEST(CurvatureFit, TheErrorIsWhatSigmaSays)
{
  // White noise: sigma counts four neighbours as one, and is twice as large as it would have to be.
  int beyond = 0;
  for (std::uint32_t seed = 0; seed < 500; ++seed) {
    const auto result = fitted([](double x, double) { return 5.0 * x * x; }, 0.1, 0.1, 0.002, seed);
    beyond += std::abs(result.curvature - 10.0) > 2.0 * result.sigma ? 1 : 0;
    ASSERT_GT(result.sigma, 0.0);
    ASSERT_LT(result.sigma, 3.0) << "seed " << seed;
  }
  EXPECT_LE(beyond, 5) << "of 500 beyond two standard deviations";
}

TEST(CurvatureFit, OfANarrowStripTheCurvatureIsUncertain)
{
  const auto flat = [](double, double) { return 0.0; };
  const auto narrow = fitted(flat, 0.03, 0.3, 0.002);
  const auto wide = fitted(flat, 0.3, 0.3, 0.002);
  EXPECT_GT(narrow.sigma, 10.0 * wide.sigma);
  EXPECT_LT(narrow.curvature, 3.0 * narrow.sigma) << "noise is no curvature";
}

TEST(CurvatureFit, TooFewPointsSayNothing)
{
  CurvatureFit fit(kFacing, kCentre);
  EXPECT_EQ(fit.solve().curvature, 0.0);
  for (int k = 0; k < 24; ++k) {
    const double x = 0.01 * (k % 5);
    const double y = 0.01 * (k / 5);
    fit.add((kCentre + Eigen::Vector3d(x, y, 20.0 * x * x)).cast<float>(), 1e5F);
  }
  EXPECT_EQ(fit.solve().curvature, 0.0) << "24 points";
  fit.add((kCentre + Eigen::Vector3d(0.04, 0.04, 20.0 * 0.0016)).cast<float>(), 1e5F);
  EXPECT_NEAR(fit.solve().curvature, 40.0, 0.1) << "25 points";
}

TEST(CurvatureFit, PointsOnALineSayNothingThatIsNotFinite)
{
  CurvatureFit fit(kFacing, kCentre);
  for (int k = 0; k < 60; ++k) fit.add((kCentre + Eigen::Vector3d(0.01 * k, 0.0, 0.0)).cast<float>(), 1e5F);
  EXPECT_TRUE(std::isfinite(fit.solve().curvature));
  EXPECT_TRUE(std::isfinite(fit.solve().sigma));
}

}  // namespace
}  // namespace polygonal_perception::perception
