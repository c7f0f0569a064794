#include "cameras/simulation/route.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::simulation {
namespace {

constexpr std::size_t kStops = 8;
constexpr int kWays = 6;              // of which the longest is taken
constexpr int kTries = 2000;          // for a free place
constexpr int kLegTries = 12;         // for a place that a straight way leads to; the farthest wins
constexpr double kStop = 0.5;         // [m] the way is free for this beyond a stop, if one looks ahead
constexpr double kShortestLeg = 0.5;  // [s]
constexpr double kPeak = 1.5;         // highest speed of the easing function over its mean

Waypoint drawAnywhere(const ViewArea& area, Random& random)
{
  const Eigen::Vector2d local =
      area.half_size.cwiseProduct(Eigen::Vector2d(random.uniform(-1, 1), random.uniform(-1, 1)));
  return {area.centre + Eigen::Rotation2Dd(area.yaw) * local,
          area.yaw + random.uniform(-area.yaw_spread, area.yaw_spread)};
}

/// The farthest of some places that a straight way leads to; where there is none, another heading at the same
/// place.
Waypoint drawNext(const FreeSpace& space, const ViewArea& area, Random& random, const Waypoint& last,
                  double beyond)
{
  Waypoint next{last.position, drawAnywhere(area, random).yaw};
  for (int i = 0; i < kLegTries; ++i) {
    const Waypoint other = drawAnywhere(area, random);
    const Eigen::Vector2d way = other.position - last.position;
    if (way.norm() <= (next.position - last.position).norm()) continue;
    if (space.containsSegment(last.position, other.position + beyond * way.normalized())) next = other;
  }
  return next;
}

/// The longest of some ways: not one from a corner between tables that leads nowhere.
std::vector<Waypoint> drawStops(const FreeSpace& space, const ViewArea& area, Random& random, double beyond)
{
  std::vector<Waypoint> best;
  double best_length = -1.0;
  for (int i = 0; i < kWays; ++i) {
    std::vector<Waypoint> stops{drawPose(space, area, random)};
    double length = 0.0;
    while (stops.size() < kStops) {
      stops.push_back(drawNext(space, area, random, stops.back(), beyond));
      length += (stops.back().position - stops[stops.size() - 2].position).norm();
    }
    if (length <= best_length) continue;
    best_length = length;
    best = std::move(stops);
  }
  return best;
}

}  // namespace

Waypoint drawPose(const FreeSpace& space, const ViewArea& area, Random& random)
{
  for (int i = 0; i < kTries; ++i) {
    Waypoint pose = drawAnywhere(area, random);
    if (space.contains(pose.position)) return pose;
  }
  throw std::runtime_error("a scene leaves the camera no room");
}

Route::Route(const FreeSpace& space, const ViewArea& area, Random& random, const Pace& pace)
{
  const bool looks_ahead = area.yaw_spread >= geometry::kPi;
  addLegs(drawStops(space, area, random, looks_ahead ? kStop : 0.0), looks_ahead, pace);
}

Route::Route(std::vector<Waypoint> places, const Pace& pace)
{
  addLegs(std::move(places), true, pace);
}

void Route::addLegs(std::vector<Waypoint> stops, bool looks_ahead, const Pace& pace)
{
  // There and back again.
  for (std::size_t i = stops.size() - 1; i-- > 0;) stops.push_back(stops[i]);
  if (!looks_ahead) {
    for (const Waypoint& stop : stops) addPlace(stop, pace);
    return;
  }
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const Eigen::Vector2d way = stops[i + 1].position - stops[i].position;
    const double yaw = way.norm() > 0.0 ? std::atan2(way.y(), way.x()) : stops[i].yaw;
    addPlace({stops[i].position, yaw}, pace);
    addPlace({stops[i + 1].position, yaw}, pace);
  }
  addPlace(places_.front(), pace);
}

void Route::addPlace(const Waypoint& place, const Pace& pace)
{
  if (places_.empty()) {
    places_.push_back(place);
    arrivals_.push_back(0.0);
    return;
  }
  const Waypoint last = places_.back();
  // Turn by the shorter way.
  const double turn = std::remainder(place.yaw - last.yaw, 2.0 * geometry::kPi);
  const double duration =
      std::max((place.position - last.position).norm() / pace.speed, std::abs(turn) / pace.turn_rate);
  places_.push_back({place.position, last.yaw + turn});
  arrivals_.push_back(arrivals_.back() + std::max(kShortestLeg, kPeak * duration));
}

Waypoint Route::at(double time) const
{
  const double t = std::fmod(time, arrivals_.back());
  const auto next = std::upper_bound(arrivals_.begin() + 1, arrivals_.end() - 1, t);
  const auto leg = static_cast<std::size_t>(next - arrivals_.begin());
  const double part = (t - arrivals_[leg - 1]) / (arrivals_[leg] - arrivals_[leg - 1]);
  const double eased = part * part * (3.0 - 2.0 * part);
  const Waypoint& from = places_[leg - 1];
  const Waypoint& to = places_[leg];
  return {from.position + eased * (to.position - from.position), from.yaw + eased * (to.yaw - from.yaw)};
}

}  // namespace polygonal_perception::simulation
