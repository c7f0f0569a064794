#include <gtest/gtest.h>

#include <cmath>

#include "polygonal_perception/cameras/simulation/driven_robot.hpp"

namespace polygonal_perception::simulation {
namespace {

DrivenRobot::Parameters parameters()
{
  DrivenRobot::Parameters parameters;
  parameters.model = {0.5, -0.5, 0.5, -0.5, 1.0, 1.0, 1.0, 2.0};
  return parameters;
}

class DrivenRobotTest : public testing::Test
{
protected:
  DrivenRobotTest() : scene_(makeScene("office", 1)) {}

  /// Says the same again and again, as a driver does.
  void drive(DrivenRobot& robot, const planning::Twist& twist, double duration)
  {
    for (double end = time_ + duration; time_ < end - 1e-9; robot.advanceTo(time_ += 0.05))
      robot.command(twist);
  }

  Scene scene_;
  double time_ = 0.0;
};

TEST_F(DrivenRobotTest, StandsWhereRobotinoStartsUntilItIsTold)
{
  DrivenRobot robot(scene_, 1, parameters());
  const auto robotino = makeTrajectory("robotino", scene_, 1);
  robot.advanceTo(3.0);
  EXPECT_TRUE(robot.pose(0.0).isApprox(robotino->pose(0.0), 1e-9));
  EXPECT_EQ(robot.state().velocity.speed(), 0.0);
}

TEST_F(DrivenRobotTest, FollowsWithinItsLimits)
{
  DrivenRobot robot(scene_, 1, parameters());
  const planning::RobotState start = robot.state();
  robot.command({0.0, 0.0, 5.0});
  robot.advanceTo(0.2);
  EXPECT_NEAR(robot.state().velocity.theta, 0.4, 1e-9) << "at 2 rad/s^2";
  robot.advanceTo(0.5);
  EXPECT_NEAR(robot.state().velocity.theta, 1.0, 1e-9) << "no faster than it can";
  EXPECT_NEAR(robot.state().pose.yaw - start.pose.yaw, 0.25, 0.01);
}

TEST_F(DrivenRobotTest, StopsWithoutACommandForLong)
{
  DrivenRobot robot(scene_, 1, parameters());
  robot.command({0.0, 0.0, 1.0});
  robot.advanceTo(0.5);
  EXPECT_GT(robot.state().velocity.theta, 0.9);
  robot.advanceTo(1.1);
  EXPECT_EQ(robot.state().velocity.theta, 0.0);
}

TEST_F(DrivenRobotTest, HasItsLatency)
{
  DrivenRobot::Parameters late = parameters();
  late.latency = 0.2;
  DrivenRobot robot(scene_, 1, late);
  robot.command({0.0, 0.0, 1.0});
  robot.advanceTo(0.2);
  EXPECT_EQ(robot.state().velocity.theta, 0.0);
  robot.advanceTo(0.3);
  EXPECT_NEAR(robot.state().velocity.theta, 0.2, 1e-9);
}

TEST_F(DrivenRobotTest, BumpsOnceAndGoesNoFarther)
{
  DrivenRobot robot(scene_, 1, parameters());
  drive(robot, {0.5, 0.0, 0.0}, 60.0);
  EXPECT_EQ(robot.bumps(), 1U) << "there is a wall, or something before it";
  const Eigen::Vector2d before = robot.state().pose.position;
  drive(robot, {0.5, 0.0, 0.0}, 1.0);
  EXPECT_LT((robot.state().pose.position - before).norm(), 1e-9);
  drive(robot, {-0.5, 0.0, 0.0}, 1.0);
  EXPECT_GT((robot.state().pose.position - before).norm(), 0.1) << "backwards it gets away";
}

TEST_F(DrivenRobotTest, ATimeThatJumpsBackIsANewBeginning)
{
  DrivenRobot robot(scene_, 1, parameters());
  const planning::RobotState start = robot.state();
  drive(robot, {0.1, 0.0, 0.5}, 1.0);
  robot.advanceTo(0.0);
  EXPECT_EQ(robot.state().pose.position, start.pose.position);
  EXPECT_EQ(robot.state().pose.yaw, start.pose.yaw);
}

}  // namespace
}  // namespace polygonal_perception::simulation
