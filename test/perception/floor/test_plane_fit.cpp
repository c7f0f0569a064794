#include <gtest/gtest.h>

#include "perception/floor/plane_fit.hpp"

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

}  // namespace
}  // namespace polygonal_perception::perception
