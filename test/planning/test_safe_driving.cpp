// Thousands of random rooms: a robot drives by the window's commands, and never touches what stands or, unless it stands
// itself, what moves.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

#include "polygonal_perception/planning/dynamic_window.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/arc_march.hpp"
#include "reference/random_obstacles.hpp"

namespace polygonal_perception::test {
namespace {

using namespace planning;
using reference::MovingObstacles;

constexpr double kSize = 8.0;     // [m]
constexpr double kPeriod = 0.05;  // [s]
constexpr double kTouch = 1e-3;   // [m] as deep as the steps of 10 ms may cut a curve
constexpr double kStands = 0.05;  // [m/s]
constexpr int kTicks = 400;

class Room
{
public:
  Room(std::uint32_t seed, const RobotModel& robot, std::size_t people) : random_(seed)
  {
    parameters_.robot = robot;
    window_.configure(parameters_);
    standing_.polygons = reference::randomObstacles(random_, 10, kSize, reference::Raster::kFloat);
    appendMovingEdges(standing_.polygons, Eigen::Vector2d::Zero(), 0.0, edges_);
    planner_.setObstacles(standing_.polygons, {}, true);
    for (std::size_t i = 0; i < people; ++i) people_.push_back(person());
  }

  /// Drives until it arrives, or for a while. @return what went wrong, or nothing
  std::string drive()
  {
    RobotState state;
    state.pose = {place(), number(-M_PI, M_PI)};
    const Eigen::Vector2d goal = place();
    if (depth(state.pose.position, 0.0) > 0.0) return {};
    for (int tick = 0; tick < kTicks; ++tick) {
      const double now = tick * kPeriod;
      planner_.makePlan(state.pose.position, goal, kSize, plan_);
      if (plan_.path.empty()) return {};
      const DriveDecision decision =
          window_.decide(state, edges_, movingEdges(now), plan_.path, 0.0, kPeriod);
      arrived_ = decision.outcome == DriveDecision::Outcome::kArrived;
      if (arrived_) return {};
      if (const std::string fault = follow(decision.command, now, state); !fault.empty()) return fault;
    }
    return {};
  }

  bool hasArrived() const { return arrived_; }

private:
  double number(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Eigen::Vector2d place() { return reference::randomPoint(random_, 0.0, kSize, reference::Raster::kFloat); }

  MovingObstacles person()
  {
    constexpr int kSides = 16;
    MovingObstacles one;
    const Eigen::Vector2d middle = place();
    std::vector<Eigen::Vector2d> ring;
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * M_PI * k / kSides;
      ring.push_back(middle + 0.5 * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    one.polygons.append(ring, false);
    one.velocity = {number(-1.2, 1.2), number(-1.2, 1.2)};
    return one;
  }

  std::vector<MovingEdge> movingEdges(double now) const
  {
    std::vector<MovingEdge> edges;
    for (const MovingObstacles& one : people_) appendMovingEdges(one.polygons, one.velocity, 0.0, edges);
    for (MovingEdge& edge : edges) edge.from += now * edge.velocity;
    return edges;
  }

  double depth(const Eigen::Vector2d& p, double now) const
  {
    double depth = reference::depthIn(standing_, p, now);
    for (const MovingObstacles& one : people_) depth = std::max(depth, reference::depthIn(one, p, now));
    return depth;
  }

  std::string follow(const Twist& command, double now, RobotState& state) const
  {
    constexpr int kSteps = 5;
    constexpr double kStep = kPeriod / kSteps;
    for (int i = 1; i <= kSteps; ++i) {
      state = parameters_.robot.advanced(state, command, kStep);
      const double speed = state.velocity.speed();
      const double standing = reference::depthIn(standing_, state.pose.position, 0.0);
      const double any = speed < kStands ? standing : depth(state.pose.position, now + i * kStep);
      if (any <= kTouch) continue;
      std::ostringstream text;
      text << any << " m deep in " << (standing > kTouch ? "what stands" : "what moves") << " at "
           << state.pose.position.transpose() << " after " << now + i * kStep << " s, at " << speed << " m/s";
      return text.str();
    }
    return {};
  }

  std::mt19937 random_;
  DrivingParameters parameters_;
  DynamicWindow window_;
  PathPlanner planner_;
  MovingObstacles standing_;
  std::vector<MovingEdge> edges_;
  std::vector<MovingObstacles> people_;
  Plan plan_;
  bool arrived_ = false;
};

void checkRooms(const RobotModel& robot, std::size_t people, std::uint32_t rooms)
{
  std::uint32_t arrived = 0;
  for (std::uint32_t seed = 1; seed <= rooms; ++seed) {
    Room room(seed, robot, people);
    const std::string fault = room.drive();
    ASSERT_EQ(fault, "") << "seed " << seed;
    arrived += room.hasArrived() ? 1 : 0;
  }
  EXPECT_GT(arrived, rooms / 2) << "of " << rooms;
  std::printf("%u of %u arrived\n", arrived, rooms);
}

constexpr RobotModel kFast{2.0, -0.5, 0.0, 0.0, 1.57, 10.0, 0.0, 20.0};
constexpr RobotModel kGentle{1.0, -0.2, 0.0, 0.0, 1.5, 1.0, 0.0, 3.0};
constexpr RobotModel kOmnidirectional{1.0, -0.5, 0.5, -0.5, 1.5, 2.0, 2.0, 3.0};

TEST(SafeDriving, AFastRobot)
{
  checkRooms(kFast, 0, 60);
}

TEST(SafeDriving, AGentleRobot)
{
  checkRooms(kGentle, 0, 60);
}

TEST(SafeDriving, AnOmnidirectionalRobot)
{
  checkRooms(kOmnidirectional, 0, 10);
}

TEST(SafeDriving, AmongPeople)
{
  checkRooms(kFast, 4, 60);
  checkRooms(kGentle, 4, 60);
  checkRooms(kOmnidirectional, 4, 8);
}

}  // namespace
}  // namespace polygonal_perception::test
