#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "polygonal_perception/planning/path_planner.hpp"

namespace polygonal_perception::planning {
namespace {

using geometry::PolygonSet;
using Ring = std::vector<Eigen::Vector2d>;

Ring box(double left, double bottom, double right, double top)
{
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Ring reversed(Ring ring)
{
  std::reverse(ring.begin(), ring.end());
  return ring;
}

const Ring kExtent = box(-5, -5, 5, 5);

class PathPlannerTest : public testing::Test
{
protected:
  void setBoxes(const std::vector<Ring>& boxes, bool outside_is_free = true)
  {
    PolygonSet set;
    for (const Ring& ring : boxes) set.append(ring, false);
    const auto fault = planner_.setObstacles(set, kExtent, outside_is_free);
    ASSERT_FALSE(fault) << fault->text;
  }
  const Plan& plan(const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double tolerance = 0.3)
  {
    planner_.makePlan(start, goal, tolerance, plan_);
    EXPECT_EQ(plan_.path.empty(), plan_.outcome != PlanOutcome::kOk);
    return plan_;
  }

  PathPlanner planner_;
  Plan plan_;
};

TEST_F(PathPlannerTest, WithoutPolygonsThereIsNoPlan)
{
  EXPECT_EQ(plan({0, 0}, {1, 0}).outcome, PlanOutcome::kNoPolygons);
}

TEST_F(PathPlannerTest, RefusedObstaclesAreNone)
{
  setBoxes({});
  EXPECT_EQ(plan({0, 0}, {1, 0}).outcome, PlanOutcome::kOk);
  PolygonSet clockwise;
  clockwise.append(reversed(box(0, 0, 1, 1)), false);
  EXPECT_TRUE(planner_.setObstacles(clockwise, kExtent, true));
  EXPECT_EQ(plan({0, 0}, {1, 0}).outcome, PlanOutcome::kNoPolygons);
}

TEST_F(PathPlannerTest, AStartInAnObstacleLeavesItByTheShortestWay)
{
  setBoxes({box(0, 0, 2, 2)});
  const Plan& made = plan({0.2, 1}, {4, 1});
  ASSERT_EQ(made.outcome, PlanOutcome::kOk);
  EXPECT_DOUBLE_EQ(made.start_shift, 0.2);
  ASSERT_GE(made.path.size(), 4U);
  EXPECT_EQ(made.path[0], Eigen::Vector2d(0.2, 1));
  EXPECT_EQ(made.path[1], Eigen::Vector2d(0, 1));
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < made.path.size(); ++i) length += (made.path[i + 1] - made.path[i]).norm();
  EXPECT_DOUBLE_EQ(made.length, length);
}

TEST_F(PathPlannerTest, AGoalInAnObstacleBecomesTheNearestFreePointWithinTheTolerance)
{
  setBoxes({box(0, 0, 2, 2)});
  const Plan& made = plan({-2, 1}, {0.25, 1});
  ASSERT_EQ(made.outcome, PlanOutcome::kOk);
  EXPECT_EQ(made.path.back(), Eigen::Vector2d(0, 1));
  EXPECT_DOUBLE_EQ(made.goal_shift, 0.25);
  EXPECT_EQ(plan({-2, 1}, {1, 1}).outcome, PlanOutcome::kGoalBlocked);
  EXPECT_EQ(plan({-2, 1}, {1, 1}, 1.0).outcome, PlanOutcome::kOk);
  EXPECT_EQ(plan({-2, 1}, {0.25, 1}, 0.0).outcome, PlanOutcome::kGoalBlocked);
}

TEST_F(PathPlannerTest, AGoalInAWallIsTakenOnTheSideThatCanBeReached)
{
  PolygonSet set;
  set.append(box(-3, -3, 3, 3), false);
  set.append(reversed(box(-2.8, -2.8, 2.8, 2.8)), true);
  ASSERT_FALSE(planner_.setObstacles(set, kExtent, true));
  // 5 cm from inside and 15 cm from outside.
  EXPECT_EQ(plan({0, 0}, {2.85, 0}).path.back(), Eigen::Vector2d(2.8, 0));
  EXPECT_EQ(plan({4, 0}, {2.85, 0}).path.back(), Eigen::Vector2d(3, 0));
  EXPECT_EQ(plan({4, 0}, {2.85, 0}, 0.1).outcome, PlanOutcome::kUnreachable);
}

TEST_F(PathPlannerTest, WhatIsWalledInIsUnreachable)
{
  PolygonSet set;
  set.append(box(-3, -3, 3, 3), false);
  set.append(reversed(box(-2, -2, 2, 2)), true);
  ASSERT_FALSE(planner_.setObstacles(set, kExtent, true));
  EXPECT_EQ(plan({0, 0}, {4, 0}).outcome, PlanOutcome::kUnreachable);
  EXPECT_EQ(plan({4, 0}, {0, 0}).outcome, PlanOutcome::kUnreachable);
}

TEST_F(PathPlannerTest, BeyondTheExtentIsFreeOrBlocked)
{
  // From one border of the extent to the other.
  const Ring wall = box(-0.5, -5, 0.5, 5);
  setBoxes({wall}, true);
  EXPECT_EQ(plan({-2, 0}, {2, 0}).outcome, PlanOutcome::kOk) << "around its end";
  EXPECT_EQ(plan({-2, 0}, {2, 9}).outcome, PlanOutcome::kOk);
  setBoxes({wall}, false);
  EXPECT_EQ(plan({-2, 0}, {2, 0}).outcome, PlanOutcome::kUnreachable);
  EXPECT_EQ(plan({-2, 0}, {-2, 9}).outcome, PlanOutcome::kOutside);
  EXPECT_EQ(plan({-9, 0}, {-2, 0}).outcome, PlanOutcome::kOutside);
  EXPECT_EQ(plan({-2, 0}, {-5, 5}).outcome, PlanOutcome::kOk) << "its border is inside";
  setBoxes({box(-0.5, -4.9, 0.5, 5)}, false);
  EXPECT_EQ(plan({-2, 0}, {2, 0}).outcome, PlanOutcome::kOk) << "through the gap along the border";
}

TEST_F(PathPlannerTest, PlacesThatAreNoNumbersAreOutside)
{
  setBoxes({box(0, 0, 1, 1)});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(plan({nan, 0}, {2, 0}).outcome, PlanOutcome::kOutside);
  EXPECT_EQ(plan({2, 0}, {2, std::numeric_limits<double>::infinity()}).outcome, PlanOutcome::kOutside);
  EXPECT_EQ(plan({2, 0}, {1e12, 0}).outcome, PlanOutcome::kOutside);
}

TEST_F(PathPlannerTest, WhereEverythingIsBlockedTheStartIs)
{
  setBoxes({box(-6, -6, 6, 6)}, false);
  EXPECT_EQ(plan({0, 0}, {1, 0}).outcome, PlanOutcome::kStartBlocked);
}

/// Plans one after the other, each on the last one's side of obstacles.
class KeepSideTest : public PathPlannerTest
{
protected:
  /// The point of the path farthest from the line y = 0, with its sign.
  double side(const Eigen::Vector2d& start, const Eigen::Vector2d& goal, double share = 0.1)
  {
    planner_.makePlan(start, goal, 0.3, plan_);
    EXPECT_EQ(plan_.outcome, PlanOutcome::kOk);
    planner_.keepSide(share, guide_, plan_);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < plan_.path.size(); ++i)
      length += (plan_.path[i + 1] - plan_.path[i]).norm();
    EXPECT_NEAR(plan_.length, length, 1e-12);
    EXPECT_EQ(plan_.path.front(), start);
    const auto farther = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
      return std::abs(a.y()) < std::abs(b.y());
    };
    return std::max_element(plan_.path.begin(), plan_.path.end(), farther)->y();
  }

  std::vector<Eigen::Vector2d> guide_;
};

TEST_F(KeepSideTest, OnlyAWayThatIsShorterByTheShareIsTakenInstead)
{
  setBoxes({box(-0.5, -1, 0.5, 1)});
  EXPECT_EQ(side({-2, 0.1}, {2, 0}), 1.0);
  EXPECT_EQ(plan_.detour, 0.0);
  EXPECT_EQ(side({-2, -0.1}, {2, 0}), 1.0) << "the other side is shorter by 2 per cent";
  EXPECT_NEAR(plan_.detour, std::hypot(1.5, 1.1) - std::hypot(1.5, 0.9), 1e-12);
  EXPECT_EQ(side({-2, -0.1}, {2, 0}, 0.01), -1.0);
  EXPECT_EQ(plan_.detour, 0.0);
  EXPECT_EQ(side({-2, 0.1}, {2, 0}), -1.0);
  EXPECT_EQ(side({-2, 1}, {2, 0}), 1.0) << "the other side is shorter by 17 per cent";
}

TEST_F(KeepSideTest, WithoutAShareEachPlanIsTheShortest)
{
  setBoxes({box(-0.5, -1, 0.5, 1)});
  EXPECT_EQ(side({-2, 0.01}, {2, 0}, 0.0), 1.0);
  EXPECT_EQ(side({-2, -0.01}, {2, 0}, 0.0), -1.0);
}

TEST_F(KeepSideTest, ASideThatIsBlockedIsLeft)
{
  setBoxes({box(-0.5, -1, 0.5, 1), box(-5, 2, 5, 2.5)}, false);
  EXPECT_EQ(side({-2, 0.1}, {2, 0}), 1.0);
  setBoxes({box(-0.5, -1, 0.5, 2.2), box(-5, 2, 5, 2.5)}, false);
  EXPECT_EQ(side({-2, 0.1}, {2, 0}), -1.0);
}

TEST_F(KeepSideTest, ObstaclesMayMoveByMoreThanTheGuideIsClearOfThem)
{
  const Eigen::Vector2d start(-3, 0);
  setBoxes({box(-0.5, -1, 0.5, 1)});
  ASSERT_EQ(side(start, {3, 0.001}), 1.0);
  setBoxes({box(-0.5, -1, 0.5, 1.4)});
  EXPECT_EQ(side(start, {3, 0.001}), 1.4);
  setBoxes({box(-0.8, -1, 0.2, 0.9)});
  EXPECT_EQ(side(start, {3, 0}), 0.9);
  setBoxes({box(-0.6, -1, 0.6, 1), box(-0.1, 1.2, 0.1, 1.6)});
  EXPECT_EQ(side(start, {3, 0}), 1.0) << "between both";
  setBoxes({box(-0.5, -1, 0.5, 1), box(-0.5, -1.6, 0.5, -1.1)});
  EXPECT_EQ(side(start, {3, 0}), 1.0);
}

TEST_F(KeepSideTest, ARobotThatIsUnderWayKeepsItsSideOfWhatIsAhead)
{
  setBoxes({box(-0.5, -1, 0.5, 1), box(3, -1, 4, 1.05)});
  ASSERT_EQ(side({-2, 0.1}, {6, 0}), 1.05);
  EXPECT_EQ(side({-0.5, 1}, {6, 0}), 1.05);
  EXPECT_EQ(side({1, 0}, {6, 0}), 1.05) << "away from the path";
  EXPECT_GT(plan_.detour, 0.0);
  EXPECT_EQ(side({4, 1.05}, {6, 0}), 1.05);
  EXPECT_EQ(side({6, 0}, {6, 0}), 0.0);
}

TEST_F(KeepSideTest, AGoalInAnObstacleIsReachedOnTheLastSideToo)
{
  // Beside slanted borders, on which the nearest points lie but for rounding.
  const Eigen::Vector2d goal(2.35, 0.0);
  for (int i = 0; i < 100; ++i) {
    Ring slanted;
    for (int k = 0; k < 4; ++k)
      slanted.emplace_back(3.0 + std::cos(0.01 * i + k * M_PI / 2.0), std::sin(0.01 * i + k * M_PI / 2.0));
    setBoxes({box(-0.5, -1, 0.5, 1), slanted});
    for (const double above : {0.3, -0.3}) {
      guide_.clear();
      planner_.makePlan({-2, above}, goal, 1.0, plan_);
      planner_.keepSide(1.0, guide_, plan_);
      const bool passes_above = plan_.path[1].y() > 0.0;
      planner_.makePlan({-2, -above}, goal, 1.0, plan_);
      planner_.keepSide(1.0, guide_, plan_);
      ASSERT_GT(plan_.goal_shift, 0.0);
      ASSERT_EQ(plan_.path[1].y() > 0.0, passes_above) << "turned by " << 0.01 * i << ", from " << -above;
    }
  }
}

TEST_F(KeepSideTest, AStartInAnObstacleLeavesItFirst)
{
  setBoxes({box(-0.5, -1, 0.5, 1)});
  ASSERT_EQ(side({-0.4, 0.1}, {2, 0}), 1.0);
  EXPECT_EQ(side({-0.4, -0.1}, {2, 0}), 1.0);
  EXPECT_NEAR(plan_.start_shift, 0.1, 1e-12);
  EXPECT_TRUE(plan_.path[1].isApprox(Eigen::Vector2d(-0.5, -0.1))) << plan_.path[1].transpose();
  EXPECT_GT(plan_.detour, 0.0);
}

}  // namespace
}  // namespace polygonal_perception::planning
