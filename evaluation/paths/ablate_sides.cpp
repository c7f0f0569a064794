// What PathParameters::side_hysteresis is worth, printed as markdown (scripts/ablate_sides).
#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <random>

#include "paths/path_scenes.hpp"
#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/planning/path_parameters.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/still_view.hpp"

namespace polygonal_perception::evaluation {
namespace {

constexpr double kJump = 0.5;  // [m] paths are as far apart where one passes another side
const double kTolerance = planning::PathParameters{}.goal_tolerance;

/// A robot that follows its plan to a goal, and the next plan, and so on.
struct Robot
{
  Eigen::Vector2d position;
  Eigen::Vector2d goal;
  std::vector<Eigen::Vector2d> guide;
  std::vector<Eigen::Vector2d> path;  // what remains of the last plan
  double driven = 0.0;                // [m]
  std::optional<double> direct;       // [m] the first plan
  double rest = 0.0;                  // [m] of the last plan
  bool is_there = false;
};

struct Counts
{
  std::size_t plans = 0;
  std::size_t jumps = 0;
  std::size_t soon = 0;  // after another
  double driven = 0.0;   // [m] and what was left to drive in the end
  double direct = 0.0;   // [m]
};

using Line = std::vector<Eigen::Vector2d>;

/// Follows a path, and leaves what remains of it.
void follow(Line& path, double far)
{
  std::size_t next = 1;
  for (; next + 1 < path.size(); ++next) {
    const double length = (path[next] - path[next - 1]).norm();
    if (far < length) break;
    far -= length;
  }
  const Eigen::Vector2d way = path[next] - path[next - 1];
  path[next - 1] += std::min(1.0, far / std::max(far, way.norm())) * way;
  path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(next) - 1);
}

/// [m] How far a line's corners are from another line, at most.
double distance(const Line& corners, const Line& line)
{
  double most = 0.0;
  for (const Eigen::Vector2d& corner : corners) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      least = std::min(least, (geometry::nearestOnSegment(corner, line[i], line[i + 1]) - corner).norm());
    most = std::max(most, least);
  }
  return most;
}

class Drive
{
public:
  Drive(double share, double step, std::vector<Robot> robots)
      : share_(share), step_(step), robots_(std::move(robots)), last_(robots_.size(), -kSoon)
  {
  }

  void plan(const geometry::PolygonSet& obstacles)
  {
    planner_.setObstacles(obstacles, {}, true);
    for (std::size_t i = 0; i < robots_.size(); ++i) advance(robots_[i], last_[i]);
    ++frame_;
  }

  void addTo(Counts& counts) const
  {
    counts.plans += counts_.plans;
    counts.jumps += counts_.jumps;
    counts.soon += counts_.soon;
    for (const Robot& robot : robots_) {
      counts.driven += robot.driven + robot.rest;
      counts.direct += robot.direct.value_or(0.0);
    }
  }

private:
  static constexpr int kSoon = 6;  // frames

  void advance(Robot& robot, int& last)
  {
    if (robot.is_there) return;
    planner_.makePlan(robot.position, robot.goal, kTolerance, plan_);
    if (plan_.outcome != planning::PlanOutcome::kOk) return;
    const bool is_first = robot.guide.empty();
    if (is_first) robot.direct = plan_.length;
    planner_.keepSide(share_, robot.guide, plan_);
    if (!is_first) {
      ++counts_.plans;
      if (std::max(distance(plan_.path, robot.path), distance(robot.path, plan_.path)) > kJump) {
        ++counts_.jumps;
        counts_.soon += frame_ - last < kSoon ? 1 : 0;
        last = frame_;
      }
    }
    const double step = std::min(step_, plan_.length);
    robot.path = plan_.path;
    follow(robot.path, step);
    robot.position = robot.path.front();
    robot.driven += step;
    robot.rest = plan_.length - step;
    robot.is_there = robot.rest < kTolerance;
  }

  double share_;
  double step_;  // [m] from frame to frame
  std::vector<Robot> robots_;
  std::vector<int> last_;  // frame in which each path jumped
  planning::PathPlanner planner_;
  planning::Plan plan_;
  Counts counts_;
  int frame_ = 0;
};

/// What robots plan on, frame by frame.
struct Course
{
  double step = 0.0;  // [m] that they drive from frame to frame
  std::vector<Robot> robots;
  std::vector<geometry::PolygonSet> polygons;
};

std::vector<Robot> robotsIn(const Eigen::AlignedBox2d& starts, const Eigen::AlignedBox2d& goals,
                            std::size_t count)
{
  std::mt19937 random(1);
  const auto anywhere = [&](const Eigen::AlignedBox2d& box) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const double x = share(random);
    return Eigen::Vector2d(box.min() + box.sizes().cwiseProduct(Eigen::Vector2d(x, share(random))));
  };
  std::vector<Robot> robots(count);
  for (Robot& robot : robots) {
    robot.position = anywhere(starts);
    robot.goal = anywhere(goals);
  }
  return robots;
}

/// Robots that drive about while a camera shows the room, three frames a second.
Course driving(bool remembers)
{
  Course course;
  course.step = 0.5 / 3.0;  // 0.5 m/s
  course.polygons = drivenPolygons(remembers);
  Eigen::AlignedBox2d room;
  for (const Eigen::Vector2d& p : course.polygons.back().vertices) room.extend(p);
  course.robots = robotsIn(room, room, 500);
  return course;
}

/// A robot that stands still before a room, with many goals in it: its frames differ by the sensor's noise alone.
Course standing(std::uint64_t seed)
{
  constexpr std::uint32_t kFrames = 60;
  Course course;
  reference::StillView view("office", seed);
  perception::Pipeline pipeline({});
  for (std::uint32_t i = 0; i < kFrames; ++i)
    course.polygons.push_back(pipeline.process(view.frame(i), perception::Product::kPolygons).polygons);
  const Eigen::Vector2d here = Eigen::Vector2d::Zero();
  course.robots = robotsIn({here, here}, {Eigen::Vector2d(1.0, -2.5), Eigen::Vector2d(5.0, 2.5)}, 50);
  return course;
}

void printRows(const char* name, const std::vector<Course>& courses)
{
  for (const double share : {0.0, 0.05, 0.1, 0.2, 0.5}) {
    Counts counts;
    for (const Course& course : courses) {
      Drive drive(share, course.step, course.robots);
      for (const geometry::PolygonSet& obstacles : course.polygons) drive.plan(obstacles);
      drive.addTo(counts);
    }
    std::printf("| %s | %.2f | %zu | %zu | %zu | %.1f %% |\n", name, share, counts.plans, counts.jumps,
                counts.soon, 100.0 * counts.driven / counts.direct);
  }
}

}  // namespace
}  // namespace polygonal_perception::evaluation

int main()
{
  using namespace polygonal_perception::evaluation;
  std::vector<Course> still;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) still.push_back(standing(seed));
  std::printf(
      "| polygons | share | plans | jump | again within 6 frames | way, of the first plan's length |\n");
  std::printf("| --- | --: | --: | --: | --: | --: |\n");
  printRows("frame, standing", still);
  printRows("frame, driving", {driving(false)});
  printRows("map, driving", {driving(true)});
}
