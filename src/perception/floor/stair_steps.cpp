#include "perception/floor/stair_steps.hpp"

#include <cmath>
#include <optional>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

namespace {

/// How much higher a plane is where the lower one is seen [m], if it may be the next step of a staircase.
std::optional<double> rise(const FloorCandidate& lower, const FloorCandidate& upper,
                           const FloorSelectionParameters& parameters)
{
  const double rise = -upper.fit.plane.height(lower.fit.centre);
  if (rise < parameters.least_rise || rise > parameters.most_rise || lower.middle < upper.middle ||
      geometry::angleBetween(lower.fit.plane.normal, upper.fit.plane.normal) > parameters.step_angle) {
    return std::nullopt;
  }
  return rise;
}

/// Marks a step between a lower plane and any that is the next one above the step.
bool mark(const FloorCandidate& lower, FloorCandidate& step, std::vector<FloorCandidate>& candidates,
          const FloorSelectionParameters& parameters)
{
  const auto rise_to_step = rise(lower, step, parameters);
  if (!rise_to_step) return false;
  for (FloorCandidate& upper : candidates) {
    const auto rise_from_step = rise(step, upper, parameters);
    if (upper.too_low || !rise_from_step || std::abs(*rise_from_step - *rise_to_step) > parameters.same_rise)
      continue;
    step.is_step = true;
    upper.leads_down = true;
  }
  return step.is_step;
}

}  // namespace

void markStairSteps(std::vector<FloorCandidate>& candidates, const FloorSelectionParameters& parameters)
{
  // What is marked is a lower plane for the next step up, and may stand anywhere in the list.
  for (bool more = true; more;) {
    more = false;
    for (FloorCandidate& step : candidates) {
      if (step.too_low || step.is_step) continue;
      for (const FloorCandidate& lower : candidates) {
        if ((lower.too_low || lower.is_step) && mark(lower, step, candidates, parameters)) {
          more = true;
          break;
        }
      }
    }
  }
}

}  // namespace polygonal_perception::perception
