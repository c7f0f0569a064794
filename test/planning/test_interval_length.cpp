#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "planning/interval_length.hpp"

namespace polygonal_perception::planning {
namespace {

// An interval from (1, -1) to (1, 1), seen from the origin.
const Eigen::Vector2d kRight(1.0, -1.0);
const Eigen::Vector2d kLeft(1.0, 1.0);
const Eigen::Vector2d kRoot(0.0, 0.0);

TEST(IntervalLength, IsStraightWhereTheLineGoesThrough)
{
  EXPECT_DOUBLE_EQ(lengthThrough(kRight, kLeft, kRoot, {4.0, 0.5}), Eigen::Vector2d(4.0, 0.5).norm());
}

TEST(IntervalLength, BendsAroundAnEndWhereItPassesBeside)
{
  EXPECT_DOUBLE_EQ(lengthThrough(kRight, kLeft, kRoot, {1.0, 3.0}), std::sqrt(2.0) + 2.0);
  EXPECT_DOUBLE_EQ(lengthThrough(kRight, kLeft, kRoot, {2.0, -5.0}), std::sqrt(2.0) + std::sqrt(17.0));
}

TEST(IntervalLength, AGoalBeforeTheIntervalCountsAsBehindIt)
{
  EXPECT_DOUBLE_EQ(lengthThrough(kRight, kLeft, kRoot, {0.5, 0.0}), 1.5);
}

TEST(IntervalLength, IsTheLeastOverThePointsOfTheInterval)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3.0, 3.0);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d goal(place(random), place(random));
    if (std::abs(goal.x() - 1.0) < 0.1) continue;  // between two samples the length changes too much
    double least = 1e9;
    for (int k = 0; k <= 2000; ++k) {
      const Eigen::Vector2d point = kRight + k / 2000.0 * (kLeft - kRight);
      least = std::min(least, (point - kRoot).norm() + (goal - point).norm());
    }
    const double length = lengthThrough(kRight, kLeft, kRoot, goal);
    EXPECT_LE(length, least + 1e-12) << goal.transpose();
    EXPECT_NEAR(length, least, 1e-5) << goal.transpose();
  }
}

TEST(LineCrossing, IsOnTheSegmentWhateverRoundingDoes)
{
  EXPECT_TRUE(lineCrossing({0, 0}, {1, 1}, {0, 2}, {2, 0}).isApprox(Eigen::Vector2d(1, 1)));
  EXPECT_EQ(lineCrossing({0, 0}, {1, 0}, {2, 0}, {3, 0}), Eigen::Vector2d(2, 0)) << "along the line";
}

}  // namespace
}  // namespace polygonal_perception::planning
