#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perception/planes/plane_fit.hpp"
#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {
namespace {

TEST(PlaneFit, ThreePointsGiveTheirPlane)
{
  PlaneFit fit;
  fit.add(0, 0, 1, 1);
  fit.add(1, 0, 1, 1);
  fit.add(0, 1, 1, 1);
  const auto result = fit.solve(-Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->plane.normal.isApprox(-Eigen::Vector3d::UnitZ(), 1e-9))
      << result->plane.normal.transpose();
  EXPECT_NEAR(result->plane.distance, 1.0, 1e-9);
  EXPECT_NEAR(result->rms_error, 0.0, 1e-9);
}

TEST(PlaneFit, PointsOnALineSpanNoPlane)
{
  PlaneFit fit;
  for (int k = 0; k < 20; ++k) fit.add(0.1F * k, 0.2F * k, 1.0F, 1.0F);
  EXPECT_FALSE(fit.solve(Eigen::Vector3d::UnitZ()));
}

TEST(PlaneFit, TwoPointsSpanNoPlane)
{
  PlaneFit fit;
  fit.add(0, 0, 1, 1);
  fit.add(1, 0, 1, 1);
  EXPECT_FALSE(fit.solve(Eigen::Vector3d::UnitZ()));
}

TEST(PlaneFit, FarPointsKeepTheirPrecision)
{
  // A patch of 1 m, 100 m away, tilted by 1 in 100.
  PlaneFit fit;
  for (int i = 0; i < 10; ++i) {
    for (int j = 0; j < 10; ++j) fit.add(100.0F + 0.1F * i, 100.0F + 0.1F * j, 0.001F * i, 1.0F);
  }
  const auto result = fit.solve(Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(result);
  EXPECT_NEAR(-result->plane.normal.x() / result->plane.normal.z(), 0.01, 1e-5);
}

TEST(PlaneFit, AHeavyPointWeighsMore)
{
  // Two planes 2 cm apart; all weight on the upper one.
  PlaneFit fit;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      fit.add(0.1F * i, 0.1F * j, 0.00F, 1e-6F);
      fit.add(0.1F * i, 0.1F * j, 0.02F, 1.0F);
    }
  }
  const auto result = fit.solve(Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->plane.distance, -0.02, 1e-6);
}

TEST(PlaneFit, TheNormalIsTurnedUp)
{
  PlaneFit fit;
  fit.add(0, 0, 1, 1);
  fit.add(1, 0, 1, 1);
  fit.add(0, 1, 1, 1);
  EXPECT_GT(fit.solve({0.5, 0.0, 0.1})->plane.normal.z(), 0.0);
  EXPECT_LT(fit.solve({0.5, 0.0, -0.1})->plane.normal.z(), 0.0);
}

TEST(PlaneFit, SaysHowFarTheNormalMayBeOff)
{
  // Heights of +-1 cm along a side of 1 m: an error of 1 cm over the spread of 29 cm, of so many independent
  // points.
  const auto sigmaOf = [](int n) {
    PlaneFit fit;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        fit.add(static_cast<float>(i) / static_cast<float>(n - 1),
                static_cast<float>(j) / static_cast<float>(n - 1), (i + j) % 2 == 0 ? 0.01F : -0.01F, 1.0F);
      }
    }
    return fit.solve(Eigen::Vector3d::UnitZ())->normal_sigma;
  };
  EXPECT_NEAR(sigmaOf(20), 0.01 / 0.30 * 2.0 / 20.0, 2e-4) << "400 points, of which 100 are independent";
  EXPECT_NEAR(sigmaOf(10) / sigmaOf(20), 2.0, 0.2) << "a quarter of the points tell half as much";
}

/// Points of a rough patch of 1 m about (x, y), tilted by 1 in 10.
PlaneFit patch(float x, float y, float weight)
{
  PlaneFit fit;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const float at_x = x + 0.25F * static_cast<float>(i - 2);
      const float at_y = y + 0.25F * static_cast<float>(j - 2);
      fit.add(at_x, at_y, 0.1F * at_x + ((3 * i + j) % 2 == 0 ? 0.003F : -0.003F), weight);
    }
  }
  return fit;
}

TEST(PlaneFit, TwoThatAreAddedAreTheFitOfAllPoints)
{
  PlaneFit sum = patch(0.0F, 0.0F, 1.0F);
  sum.add(patch(5.0F, -3.0F, 2.0F));
  PlaneFit all = patch(0.0F, 0.0F, 1.0F);
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) {
      const float at_x = 5.0F + 0.25F * static_cast<float>(i - 2);
      all.add(at_x, -3.0F + 0.25F * static_cast<float>(j - 2),
              0.1F * at_x + ((3 * i + j) % 2 == 0 ? 0.003F : -0.003F), 2.0F);
    }
  }
  EXPECT_EQ(sum.count(), 50U);
  const auto seen = sum.solve(Eigen::Vector3d::UnitZ());
  const auto expected = all.solve(Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(seen && expected);
  EXPECT_TRUE(seen->plane.normal.isApprox(expected->plane.normal, 1e-9))
      << "seen " << seen->plane.normal.transpose() << ", expected " << expected->plane.normal.transpose();
  EXPECT_NEAR(seen->plane.distance, expected->plane.distance, 1e-9);
  EXPECT_TRUE(seen->centre.isApprox(expected->centre, 1e-9)) << seen->centre.transpose();
  EXPECT_NEAR(seen->rms_error, expected->rms_error, 1e-9);
  EXPECT_NEAR(seen->normal_sigma, expected->normal_sigma, 1e-9);
}

TEST(PlaneFit, AddingNothingChangesNothing)
{
  PlaneFit fit = patch(1.0F, 2.0F, 1.0F);
  const auto before = fit.solve(Eigen::Vector3d::UnitZ());
  fit.add(PlaneFit());
  EXPECT_EQ(fit.count(), 25U);
  EXPECT_EQ(fit.solve(Eigen::Vector3d::UnitZ())->plane.normal, before->plane.normal);
  PlaneFit empty;
  empty.add(fit);
  EXPECT_EQ(empty.count(), 25U);
  EXPECT_EQ(empty.solve(Eigen::Vector3d::UnitZ())->plane.distance, before->plane.distance);
}

TEST(PlaneFit, PointsAddedToACopyWeighAsIfTheyHadBeenThere)
{
  // The copy keeps the first one's origin, about which the sums are taken.
  PlaneFit empty;
  empty.add(patch(10.0F, 0.0F, 1.0F));
  empty.add(11.0F, 0.5F, 1.2F, 5.0F);
  PlaneFit direct = patch(10.0F, 0.0F, 1.0F);
  direct.add(11.0F, 0.5F, 1.2F, 5.0F);
  EXPECT_NEAR(empty.solve(Eigen::Vector3d::UnitZ())->plane.distance,
              direct.solve(Eigen::Vector3d::UnitZ())->plane.distance, 1e-9);
}

const geometry::Plane kKnown{Eigen::Vector3d::UnitZ(), 1.0};

/// Points along x, 2 m long, whose heights rise by `slope`; `wide` [m] across.
PlaneFit line(double slope, double wide, float weight = 1e4F)
{
  PlaneFit fit;
  for (int i = -20; i <= 20; ++i) {
    for (const double y : {-0.5, 0.5}) {
      fit.add(0.05F * static_cast<float>(i), static_cast<float>(wide * y),
              static_cast<float>(-1.2 + 0.05 * i * slope), weight);
    }
  }
  return fit;
}

TEST(PlaneFitNear, ALineOfPointsKeepsTheKnownTiltAcrossIt)
{
  const PlaneFit points = line(0.02, 0.0);
  EXPECT_FALSE(points.solve(Eigen::Vector3d::UnitZ())) << "alone they have no plane";
  const geometry::Plane known{Eigen::Vector3d(0.0, 0.1, 1.0).normalized(), 1.0};
  const auto result = points.solveNear(known, 0.05);
  ASSERT_TRUE(result);
  const Eigen::Vector3d normal = result->plane.normal / result->plane.normal.z();
  EXPECT_NEAR(normal.y(), 0.1, 2e-3) << "across the line nothing else is known";
  EXPECT_NEAR(normal.x(), -0.02, 2e-3) << "along it the points tell";
  EXPECT_NEAR(result->plane.height({0.0, 0.0, -1.2}), 0.0, 1e-6) << "it goes through the points";
}

TEST(PlaneFitNear, TheKnownOffsetSaysNothing)
{
  const auto result = line(0.0, 0.0).solveNear({Eigen::Vector3d::UnitZ(), 7.0}, 0.01);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->plane.distance, 1.2, 1e-6);
}

TEST(PlaneFitNear, PointsWinOverAWeakPriorAndAStrongOneOverPoints)
{
  const PlaneFit points = line(0.05, 1.0);
  const auto weak = points.solveNear(kKnown, 1.0);
  const auto strong = points.solveNear(kKnown, 1e-6);
  ASSERT_TRUE(weak && strong);
  EXPECT_NEAR(-weak->plane.normal.x() / weak->plane.normal.z(), 0.05, 1e-4);
  EXPECT_NEAR(-strong->plane.normal.x() / strong->plane.normal.z(), 0.0, 1e-4);
}

TEST(PlaneFitNear, BetweenTheTwoTheInformationDecides)
{
  // 82 points with a standard deviation of 0.1 m, a quarter of them independent, tell the slope as well as
  // 20.5 at their spread of 0.59 m: to 0.1 / 0.59 / sqrt(20.5) = 0.0374. What is known as well halves it.
  const auto result = line(0.05, 1.0, 100.0F).solveNear(kKnown, 0.0374);
  ASSERT_TRUE(result);
  EXPECT_NEAR(-result->plane.normal.x() / result->plane.normal.z(), 0.025, 0.001);
}

TEST(PlaneFitNear, SaysHowFarTheNormalMayStillBeOff)
{
  EXPECT_NEAR(line(0.0, 0.0).solveNear(kKnown, 0.01)->normal_sigma, 0.01, 1e-6) << "across a line, as before";
  EXPECT_LT(line(0.0, 1.0).solveNear(kKnown, 0.01)->normal_sigma, 0.005) << "points on both sides tell more";
}

TEST(PlaneFitNear, GivesTheResidualsOfThePoints)
{
  PlaneFit points;
  for (int i = 0; i < 10; ++i)
    points.add(0.1F * static_cast<float>(i), 0.0F, i % 2 == 0 ? -1.01F : -0.99F, 1.0F);
  EXPECT_NEAR(points.solveNear(kKnown, 1e-3)->rms_error, 0.01, 1e-4);
}

TEST(PlaneFitNear, AgreesWithTheFitAloneWherePointsAbound)
{
  const PlaneFit points = patch(0.0F, 0.0F, 1e6F);
  const auto alone = points.solve(Eigen::Vector3d::UnitZ());
  const auto near = points.solveNear(alone->plane, 10.0);
  ASSERT_TRUE(near);
  EXPECT_LT(geometry::angleBetween(near->plane.normal, alone->plane.normal), 1e-4);
  EXPECT_NEAR(near->plane.distance, alone->plane.distance, 1e-5);
}

TEST(PlaneFitCovariance, IsThatOfASensorWherePointsLieExactlyOnThePlane)
{
  PlaneFit points;
  for (int i = 0; i < 8; ++i) {
    for (int j = 0; j < 8; ++j)
      points.add(0.25F * static_cast<float>(i), 0.25F * static_cast<float>(j), -1.0F, 1.0F);
  }
  const auto fit = points.solve(Eigen::Vector3d::UnitZ());
  ASSERT_TRUE(fit);
  ASSERT_LT(fit->rms_error, 1e-6) << "a simulated camera without noise";
  const Eigen::Matrix4d covariance = points.covariance(*fit, std::nullopt);
  EXPECT_TRUE(covariance.allFinite()) << covariance;
  EXPECT_GT(covariance(3, 3), 0.0);
}

TEST(PlaneFitNear, TwoPointsAreTooFew)
{
  PlaneFit fit;
  EXPECT_FALSE(fit.solveNear(kKnown, 0.1));
  fit.add(0, 0, -1, 1);
  fit.add(1, 0, -1, 1);
  EXPECT_FALSE(fit.solveNear(kKnown, 0.1));
}

}  // namespace
}  // namespace polygonal_perception::perception
