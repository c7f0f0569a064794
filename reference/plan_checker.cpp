#include "reference/plan_checker.hpp"

#include <cmath>
#include <sstream>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"
#include "polygonal_perception/geometry/predicates.hpp"
#include "polygonal_perception/geometry/validity.hpp"

namespace polygonal_perception::reference {

namespace {

/// [m] From a point to the line through two others.
double besideLine(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = (to - from).normalized();
  return std::abs((point - from).x() * along.y() - (point - from).y() * along.x());
}

}  // namespace

PlanChecker::PlanChecker(const geometry::PolygonSet& obstacles)
    : obstacles_(obstacles), are_valid_(!geometry::findDefect(obstacles))
{
}

std::string PlanChecker::faultOf(const planning::Plan& plan, const Eigen::Vector2d& start,
                                 const Eigen::Vector2d& goal, double tolerance) const
{
  std::ostringstream fault;
  fault.precision(17);
  if (plan.outcome != planning::PlanOutcome::kOk) return plan.path.empty() ? "" : "a path that is none";
  if (plan.path.size() < 2) return "a path of less than two points";
  const double slack = 1e-9 * (1.0 + plan.length);
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < plan.path.size(); ++i) length += (plan.path[i + 1] - plan.path[i]).norm();
  if (!(std::abs(length - plan.length) <= slack))
    fault << "a length of " << plan.length << " and one of " << length;
  if (!((plan.path.front() - start).norm() < 1e-90)) fault << ", begins in " << plan.path.front().transpose();
  const double goal_shift = (plan.path.back() - goal).norm();
  if (!(std::abs(goal_shift - plan.goal_shift) <= slack)) fault << ", shifted by " << goal_shift;
  if (plan.goal_shift > tolerance) fault << ", beyond the tolerance";
  for (std::size_t i = plan.start_shift > 0.0 ? 1 : 0; are_valid_ && i + 1 < plan.path.size(); ++i)
    if (cuts(plan.path[i], plan.path[i + 1]))
      fault << ", cuts an obstacle from " << plan.path[i].transpose() << " to "
            << plan.path[i + 1].transpose();
  return fault.str();
}

bool PlanChecker::cuts(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  // A point that stands for one in an obstacle is on the border but for rounding.
  constexpr double kRounding = 1e-9;  // [m]
  if ((to - from).norm() < 4.0 * kRounding) return false;
  for (const auto& ring : obstacles_.rings) {
    for (const auto& edge : obstacles_.view(ring).edges()) {
      const bool beyond_rounding =
          std::min(besideLine(edge.from, from, to), besideLine(edge.to, from, to)) > kRounding &&
          std::min(besideLine(from, edge.from, edge.to), besideLine(to, edge.from, edge.to)) > kRounding;
      if (beyond_rounding && geometry::segmentsCross(from, to, edge.from, edge.to)) return true;
    }
  }
  const Eigen::Vector2d middle = 0.5 * (from + to);
  return geometry::locate(middle, obstacles_) == geometry::Location::kInside &&
         geometry::distanceToBoundary(middle, obstacles_) > kRounding;
}

}  // namespace polygonal_perception::reference
