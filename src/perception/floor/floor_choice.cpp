#include "perception/floor/floor_choice.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

namespace polygonal_perception::perception {

namespace {

/// How much higher a plane is [m], where it may be the next step of a staircase.
std::optional<double> rise(const FloorCandidate& lower, const FloorCandidate& upper)
{
  constexpr double kLeastRise = 0.1;  // [m]
  constexpr double kMostRise = 0.25;  // [m]
  constexpr double kParallel = 0.1;   // [rad] 6 degrees
  const double rise = lower.plane.distance - upper.plane.distance;
  if (rise < kLeastRise || rise > kMostRise || lower.ground_range < upper.ground_range ||
      angleBetween(lower.plane.normal, upper.plane.normal) > kParallel) {
    return std::nullopt;
  }
  return rise;
}

/// How much speaks for a candidate: its samples, less the more it tilts.
double weight(const FloorCandidate& candidate)
{
  // A tilt from the up vector at which a plane loses most of its weight.
  constexpr double kTiltScale = 0.45;  // [rad]
  // A plane that is laid through parts of two surfaces, a near table and a far floor, say, has many samples
  // but is not parallel to the surface in any of them.
  constexpr double kDisagreementScale = 0.05;  // [rad] 3 degrees
  const double tilt = candidate.tilt / kTiltScale;
  const double disagreement = candidate.disagreement / kDisagreementScale;
  return candidate.counts.inliers * std::exp(-tilt * tilt - disagreement * disagreement);
}

/// Whether a candidate is seen to lie under another one.
bool under(const FloorCandidate& lower, const FloorCandidate& upper, double lowest_possible)
{
  // What lies on the lower plane lies below the upper one. Heights alone would not tell: a steep fit through
  // the foot of a wall cuts through the floor and passes far below the camera.
  constexpr double kMostOf = 0.6;
  return upper.plane.distance < lowest_possible && lower.plane.distance > upper.plane.distance &&
         upper.counts.below > kMostOf * lower.counts.inliers;
}

}  // namespace

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void rejectStairSteps(std::vector<FloorCandidate>& candidates, std::vector<FloorCandidate>& too_low)
{
  constexpr double kSameRise = 0.03;  // [m]
  for (std::size_t k = 0; k < too_low.size(); ++k) {
    const FloorCandidate lower = too_low[k];
    for (FloorCandidate& step : candidates) {
      const auto rise_to_step = rise(lower, step);
      if (!rise_to_step || step.refused) continue;
      for (FloorCandidate& upper : candidates) {
        const auto rise_from_step = rise(step, upper);
        if (!rise_from_step || std::abs(*rise_from_step - *rise_to_step) > kSameRise) continue;
        step.refused = true;
        upper.is_stair_top = true;
      }
      if (step.refused) too_low.push_back(step);
    }
  }
}

FloorCandidate* mostLikelyFloor(std::vector<FloorCandidate>& candidates, const FloorPrior& prior,
                                double lowest_possible)
{
  FloorCandidate* best = nullptr;
  for (FloorCandidate& c : candidates) {
    const bool own = prior.confirmed && c.continues;
    if (c.refused || c.matches_other_plane || !(own || c.lowest || c.is_stair_top)) continue;
    const bool best_is_own = best != nullptr && prior.confirmed && best->continues;
    if (best == nullptr || own != best_is_own) {
      if (best == nullptr || own) best = &c;
    } else if ((!own && under(c, *best, lowest_possible)) ||
               (weight(c) > weight(*best) && (own || !under(*best, c, lowest_possible)))) {
      best = &c;
    }
  }
  return best;
}

}  // namespace polygonal_perception::perception
