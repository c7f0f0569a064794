#include "reference/plan_stress.hpp"

#include <algorithm>
#include <chrono>

#include "polygonal_perception/planning/path_planner.hpp"
#include "reference/broken_obstacles.hpp"
#include "reference/plan_checker.hpp"

namespace polygonal_perception::reference {

namespace {

constexpr int kQueriesPerSet = 50;
constexpr double kShare = 0.1;

std::vector<Eigen::Vector2d> anyExtent(std::mt19937& random, const geometry::PolygonSet& obstacles)
{
  if (random() % 4 != 0) return {{-3.0, -3.0}, {11.0, -3.0}, {11.0, 11.0}, {-3.0, 11.0}};
  std::vector<Eigen::Vector2d> extent;
  for (std::size_t i = random() % 6; i > 0; --i) extent.push_back(brokenPlace(random, obstacles));
  return extent;
}

std::string faultOf(std::mt19937& random, planning::PathPlanner& planner, const PlanChecker& checker,
                    const geometry::PolygonSet& obstacles, std::vector<Eigen::Vector2d>& guide,
                    PlanStress& result)
{
  const Eigen::Vector2d start = brokenPlace(random, obstacles);
  const Eigen::Vector2d goal = brokenPlace(random, obstacles);
  const double tolerance = 0.01 * static_cast<double>(random() % 100);
  planning::Plan plan;
  const auto begin = std::chrono::steady_clock::now();
  planner.makePlan(start, goal, tolerance, plan);
  const double shortest = plan.length;
  std::string fault = checker.faultOf(plan, start, goal, tolerance);
  planner.keepSide(kShare, guide, plan);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  ++result.queries;
  if (plan.outcome == planning::PlanOutcome::kOk) ++result.found;
  result.slowest = std::max(result.slowest, passed.count());
  if (fault.empty()) {
    fault = checker.faultOf(plan, start, goal, tolerance);
    if (!fault.empty()) fault = "on the last one's side: " + fault;
  }
  if (plan.length < shortest || (1.0 - kShare) * (plan.length - plan.start_shift) > shortest + 1e-9)
    fault += " a length of " + std::to_string(plan.length) + ", the shortest is " + std::to_string(shortest);
  return fault;
}

}  // namespace

PlanStress stressPlans(std::uint32_t first_seed, std::size_t queries)
{
  PlanStress result;
  planning::PathPlanner planner;
  std::vector<Eigen::Vector2d> guide;
  for (std::uint32_t seed = first_seed; result.queries < queries && result.fault.empty(); ++seed) {
    std::mt19937 random(seed);
    const geometry::PolygonSet obstacles = brokenObstacles(random);
    const PlanChecker checker(obstacles);
    ++result.sets;
    if (checker.areValid()) ++result.valid;
    const auto refused = planner.setObstacles(obstacles, anyExtent(random, obstacles), random() % 2 == 0);
    if (refused) ++result.refused;
    if (refused && refused->text.empty()) result.fault = "refused without a word";
    for (int i = 0; i < kQueriesPerSet && result.fault.empty(); ++i)
      result.fault = faultOf(random, planner, checker, obstacles, guide, result);
    if (!result.fault.empty()) result.fault = "seed " + std::to_string(seed) + ": " + result.fault;
  }
  return result;
}

}  // namespace polygonal_perception::reference
