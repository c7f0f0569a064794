#include <polygonal_perception/PlanStatus.h>

#include <cstdio>

#include "polygonal_perception/ros/planning/polygon_planner.hpp"

namespace polygonal_perception::ros_planning {

using planning::PlanOutcome;

namespace {

std::string pathText(const planning::Plan& plan)
{
  char text[240];
  int end = std::snprintf(text, sizeof text, "a path of %.2f m%s%s", plan.length,
                          plan.start_shift > 0.0 ? ", out of an obstacle" : "",
                          plan.goal_shift > 0.0 ? ", to the free point nearest to the goal" : "");
  if (plan.detour > 0.0)
    std::snprintf(text + end, sizeof text - static_cast<std::size_t>(end),
                  ", %.2f m longer than the shortest to stay on its side", plan.detour);
  return text;
}

}  // namespace

std::uint8_t statusOf(PlanOutcome outcome)
{
  switch (outcome) {
    case PlanOutcome::kOk:
      return PlanStatus::OK;
    case PlanOutcome::kNoPolygons:
      return PlanStatus::NO_POLYGONS;
    case PlanOutcome::kStartBlocked:
      return PlanStatus::START_BLOCKED;
    case PlanOutcome::kGoalBlocked:
      return PlanStatus::GOAL_BLOCKED;
    case PlanOutcome::kUnreachable:
      return PlanStatus::UNREACHABLE;
    case PlanOutcome::kOutside:
      break;
  }
  return PlanStatus::OUTSIDE;
}

std::string textOf(const planning::Plan& plan)
{
  switch (plan.outcome) {
    case PlanOutcome::kOk:
      return pathText(plan);
    case PlanOutcome::kNoPolygons:
      return "no polygons to plan on";
    case PlanOutcome::kStartBlocked:
      return "the robot is inside an obstacle that has no free border";
    case PlanOutcome::kGoalBlocked:
      return "the goal is inside an obstacle, and no free point is within the tolerance";
    case PlanOutcome::kUnreachable:
      return "there is no way to the goal";
    case PlanOutcome::kOutside:
      break;
  }
  return "the robot or the goal is beyond what was looked at";
}

}  // namespace polygonal_perception::ros_planning
