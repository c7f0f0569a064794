#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/planning/dynamic_window.hpp"

namespace polygonal_perception::planning {
namespace {

using Outcome = DriveDecision::Outcome;
using Line = std::vector<Eigen::Vector2d>;

constexpr double kPeriod = 0.05;     // [s]
constexpr double kStepError = 5e-4;  // [m] of a robot that moves in steps of 10 ms

DrivingParameters differential()
{
  DrivingParameters parameters;
  parameters.robot = {1.0, -0.3, 0.0, 0.0, 1.5, 1.0, 0.0, 3.0};
  return parameters;
}

DrivingParameters omnidirectional()
{
  DrivingParameters parameters;
  parameters.robot = {1.0, -0.5, 0.5, -0.5, 1.5, 2.0, 2.0, 3.0};
  return parameters;
}

std::vector<MovingEdge> box(double left, double bottom, double right, double top,
                            const Eigen::Vector2d& velocity = Eigen::Vector2d::Zero())
{
  geometry::PolygonSet set;
  set.append(Line{{left, bottom}, {right, bottom}, {right, top}, {left, top}}, false);
  std::vector<MovingEdge> edges;
  appendMovingEdges(set, velocity, 0.0, edges);
  return edges;
}

/// A robot that does what it is told.
class Driven
{
public:
  explicit Driven(const DrivingParameters& parameters) : parameters(parameters), window(parameters) {}

  DriveDecision tick(const Line& path, double goal_yaw = 0.0)
  {
    const DriveDecision decision = window.decide(state, standing, moving, path, goal_yaw, kPeriod);
    constexpr int kSteps = 5;
    for (int i = 0; i < kSteps; ++i)
      state = parameters.robot.advanced(state, decision.command, kPeriod / kSteps);
    for (MovingEdge& edge : moving) edge.from += kPeriod * edge.velocity;
    return decision;
  }
  /// Ticks until it arrives, or many times.
  DriveDecision drive(const Line& path, double goal_yaw = 0.0)
  {
    DriveDecision decision;
    for (int i = 0; i < 1000 && decision.outcome != Outcome::kArrived; ++i) decision = tick(path, goal_yaw);
    return decision;
  }

  DrivingParameters parameters;
  DynamicWindow window;
  RobotState state;
  std::vector<MovingEdge> standing;
  std::vector<MovingEdge> moving;
};

TEST(DynamicWindow, DrivesToTheGoalAndTurnsThere)
{
  for (const DrivingParameters& parameters : {differential(), omnidirectional()}) {
    Driven robot(parameters);
    const DriveDecision last = robot.drive({{0.0, 0.0}, {3.0, 1.0}}, M_PI / 2.0);
    EXPECT_EQ(last.outcome, Outcome::kArrived);
    for (int i = 0; i < 40; ++i) robot.tick({{0.0, 0.0}, {3.0, 1.0}}, M_PI / 2.0);
    EXPECT_LE((robot.state.pose.position - Eigen::Vector2d(3.0, 1.0)).norm(), parameters.xy_goal_tolerance);
    EXPECT_NEAR(robot.state.pose.yaw, M_PI / 2.0, parameters.yaw_goal_tolerance);
    EXPECT_EQ(robot.state.velocity.speed(), 0.0) << "it stands";
    EXPECT_EQ(robot.state.velocity.theta, 0.0);
  }
}

TEST(DynamicWindow, TurnsRoundToAGoalBehind)
{
  DrivingParameters parameters = differential();
  parameters.robot.min_vel_x = 0.0;
  Driven robot(parameters);
  EXPECT_EQ(robot.drive({{0.0, 0.0}, {-3.0, 0.0}}, M_PI).outcome, Outcome::kArrived);
}

TEST(DynamicWindow, GoesRoundACorner)
{
  Driven robot(differential());
  robot.standing = box(1.0, -3.0, 2.0, 0.2);
  EXPECT_EQ(robot.drive({{0.0, 0.0}, {1.0, 0.2}, {2.0, 0.2}, {3.0, -1.0}}, 0.0).outcome, Outcome::kArrived);
}

TEST(DynamicWindow, StopsBeforeAWallOnItsPath)
{
  Driven robot(differential());
  robot.standing = box(2.0, -5.0, 3.0, 5.0);
  for (int i = 0; i < 400; ++i) {
    robot.tick({{0.0, 0.0}, {5.0, 0.0}});
    ASSERT_LE(robot.state.pose.position.x(), 2.0) << "after tick " << i;
  }
  EXPECT_GT(robot.state.pose.position.x(), 1.9) << "it is as near as it can";
  EXPECT_LT(robot.state.velocity.speed(), 0.01);
}

TEST(DynamicWindow, WaitsForWhoCrosses)
{
  // A wall of a door's width crosses the path; without its velocity it would be driven into.
  for (const double start : {-1.0, -1.5, -2.0, -2.5}) {
    Driven robot(differential());
    robot.moving = box(1.5, start - 1.0, 2.0, start, {0.0, 0.8});
    for (int i = 0; i < 200; ++i) {
      robot.tick({{0.0, 0.0}, {5.0, 0.0}});
      const Eigen::Vector2d& p = robot.state.pose.position;
      const double bottom = robot.moving[0].from.y();
      const bool is_inside = p.x() > 1.5 && p.x() < 2.0 && p.y() > bottom && p.y() < bottom + 1.0;
      ASSERT_FALSE(is_inside && robot.state.velocity.speed() > 0.01) << "driven into it, after tick " << i;
    }
    EXPECT_GT(robot.state.pose.position.x(), 4.5) << "and then it goes on";
  }
}

TEST(DynamicWindow, OutOfAnObstacleByTheShortestWay)
{
  for (const DrivingParameters& parameters : {differential(), omnidirectional()}) {
    for (const double yaw : {0.0, 1.0, M_PI / 2.0 - 0.2, 2.5, M_PI}) {
      Driven robot(parameters);
      robot.standing = box(-0.2, -2.0, 3.0, 2.0);
      robot.state.pose.yaw = yaw;
      double x = robot.state.pose.position.x();
      for (int i = 0; i < 200 && x > -0.2; ++i) {
        const DriveDecision decision = robot.tick({{0.0, 0.0}, {-0.2, 0.0}, {-2.0, 0.0}}, M_PI);
        ASSERT_LE(robot.state.pose.position.x(), x + kStepError)
            << "deeper, with yaw " << yaw << " after tick " << i;
        x = robot.state.pose.position.x();
        ASSERT_NE(decision.outcome, Outcome::kBlocked) << "yaw " << yaw;
      }
      EXPECT_LE(x, -0.2) << "yaw " << yaw;
    }
  }
}

TEST(DynamicWindow, ShutInItStands)
{
  Driven robot(differential());
  for (const auto& wall : {box(-0.5, 0.01, 0.5, 0.2), box(-0.5, -0.2, 0.5, -0.01),
                           box(0.01, -0.01, 0.5, 0.01), box(-0.5, -0.01, -0.01, 0.01)})
    robot.standing.insert(robot.standing.end(), wall.begin(), wall.end());
  for (int i = 0; i < 100; ++i) {
    robot.tick({{0.0, 0.0}, {5.0, 0.0}});
    ASSERT_LE(robot.state.pose.position.cwiseAbs().maxCoeff(), 0.01 + 1e-9);
  }
}

TEST(DynamicWindow, BrakesAlongItsArc)
{
  const DynamicWindow window(differential());
  const Twist slower = window.brake({1.0, 0.0, 0.5}, kPeriod);
  EXPECT_NEAR(slower.x, 0.95, 1e-12);
  EXPECT_NEAR(slower.theta / slower.x, 0.5, 1e-12);
  const Twist still = window.brake({0.04, 0.0, 0.1}, kPeriod);
  EXPECT_EQ(still.x, 0.0);
  EXPECT_EQ(still.theta, 0.0);
}

}  // namespace
}  // namespace polygonal_perception::planning
