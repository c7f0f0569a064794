#include "polygonal_perception/planning/path_planner.hpp"

#include <algorithm>

#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::planning {

namespace {

/// Numbers so small that the predicates are not exact with them are 0.
Eigen::Vector2d withoutUnderflow(const Eigen::Vector2d& point)
{
  constexpr double kLeast = 1e-100;  // [m]
  return (point.array().abs() < kLeast).select(0.0, point);
}

}  // namespace

std::optional<geometry::TriangulationFault> PathPlanner::setObstacles(
    const geometry::PolygonSet& obstacles, const std::vector<Eigen::Vector2d>& extent, bool outside_is_free)
{
  outside_is_free_ = outside_is_free;
  extent_ = extent;
  std::optional<geometry::TriangulationFault> fault;
  if (outside_is_free || extent.size() < 3) {
    fault = space_.build(obstacles);
  } else {
    bounded_ = obstacles;
    around_.assign(extent.rbegin(), extent.rend());
    bounded_.append(around_, true);
    fault = space_.build(bounded_, true);
  }
  has_obstacles_ = !fault;
  if (has_obstacles_) search_.setSpace(space_);
  return fault;
}

bool PathPlanner::isOutside(const Eigen::Vector2d& point) const
{
  if (!space_.covers(point)) return true;
  if (outside_is_free_) return false;
  return extent_.size() < 3 ||
         geometry::locate(point, geometry::RingView(extent_)) == geometry::Location::kOutside;
}

void PathPlanner::makePlan(const Eigen::Vector2d& from_here, const Eigen::Vector2d& to_there,
                           double goal_tolerance, Plan& plan)
{
  const Eigen::Vector2d start = withoutUnderflow(from_here);
  const Eigen::Vector2d goal = withoutUnderflow(to_there);
  plan.path.clear();
  plan.length = plan.start_shift = plan.goal_shift = plan.detour = 0.0;
  const auto finish = [&plan](PlanOutcome outcome) { plan.outcome = outcome; };
  if (!has_obstacles_) return finish(PlanOutcome::kNoPolygons);
  if (isOutside(start) || isOutside(goal)) return finish(PlanOutcome::kOutside);

  std::optional<FreePlace> from = space_.locate(start);
  const bool start_is_free = from.has_value();
  // The shortest way out. It may lead into a pocket from which there is no way to the goal; a longer one would cross what is
  // between both.
  if (!from) from = space_.nearest(start);
  if (!from) return finish(PlanOutcome::kStartBlocked);
  std::optional<FreePlace> to = space_.locate(goal);
  if (!to) to = besideGoal(goal, goal_tolerance, *from);
  plan.start_shift = (from->point - start).norm();
  if (!to) return finish(PlanOutcome::kGoalBlocked);
  plan.goal_shift = (to->point - goal).norm();
  if (!isConnected(*from, *to)) return finish(PlanOutcome::kUnreachable);

  start_ = *from;
  goal_ = *to;
  const std::optional<double> length = search_.plan(start_, goal_, free_path_);
  if (!length) return finish(PlanOutcome::kUnreachable);
  plan.length = *length + plan.start_shift;
  if (!start_is_free) plan.path.push_back(start);
  plan.path.insert(plan.path.end(), free_path_.begin(), free_path_.end());
  finish(PlanOutcome::kOk);
}

void PathPlanner::keepSide(double share, std::vector<Eigen::Vector2d>& guide, Plan& plan)
{
  // Of two paths with the same corners the lengths may differ in the last digits.
  constexpr double kSame = 1e-9;
  if (plan.outcome != PlanOutcome::kOk) return;
  const double rest = plan.length - plan.start_shift;
  const auto kept = side_keeper_.follow(space_, start_, goal_, guide, kept_path_, kept_sleeve_);
  if (!kept || rest < (1.0 - share) * *kept || *kept < (1.0 + kSame) * rest) {
    search_.sleeve(sleeve_);
    SideKeeper::makeGuide(space_.mesh(), sleeve_, free_path_, guide);
    return;
  }
  plan.path.resize(plan.path.size() - free_path_.size());
  plan.path.insert(plan.path.end(), kept_path_.begin(), kept_path_.end());
  plan.detour = *kept - rest;
  plan.length = *kept + plan.start_shift;
  SideKeeper::makeGuide(space_.mesh(), kept_sleeve_, kept_path_, guide);
}

std::optional<FreePlace> PathPlanner::besideGoal(const Eigen::Vector2d& goal, double tolerance,
                                                 const FreePlace& start) const
{
  const auto isNear = [&](const std::optional<FreePlace>& place) {
    return place && (place->point - goal).norm() <= tolerance;
  };
  const std::optional<FreePlace> nearest = space_.nearest(goal);
  if (!isNear(nearest)) return std::nullopt;
  if (isConnected(start, *nearest)) return nearest;
  std::optional<FreePlace> reachable;
  space_.forEachTriangleAt(start, [&](std::uint32_t half_edge) {
    const auto place = space_.nearest(goal, space_.region(half_edge));
    if (isNear(place) && (!reachable || (place->point - goal).norm() < (reachable->point - goal).norm()))
      reachable = place;
  });
  return reachable ? reachable : nearest;
}

bool PathPlanner::isConnected(const FreePlace& a, const FreePlace& b) const
{
  bool connected = false;
  space_.forEachTriangleAt(a, [&](std::uint32_t from) {
    space_.forEachTriangleAt(
        b, [&](std::uint32_t to) { connected = connected || space_.region(from) == space_.region(to); });
  });
  return connected;
}

}  // namespace polygonal_perception::planning
