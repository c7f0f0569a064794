#include "route.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace polygonal_perception {
namespace simulation {
namespace {

constexpr int kPlaces = 8;
constexpr int kTries = 2000;   // for a free place
constexpr int kLegTries = 20;  // for a place that a straight way leads to
constexpr double kPeak = 1.5;  // highest speed of the easing function over its mean

RoutePose drawAnywhere(const ViewArea& area, Random& random)
{
  const Eigen::Vector2d local =
      area.half_size.cwiseProduct(Eigen::Vector2d(random.uniform(-1, 1), random.uniform(-1, 1)));
  return {area.centre + Eigen::Rotation2Dd(area.yaw) * local,
          area.yaw + random.uniform(-area.yaw_spread, area.yaw_spread)};
}

}  // namespace

RoutePose drawPose(const FreeSpace& space, const ViewArea& area, Random& random)
{
  for (int i = 0; i < kTries; ++i) {
    RoutePose pose = drawAnywhere(area, random);
    if (space.contains(pose.position)) return pose;
  }
  throw std::runtime_error("a scene leaves the camera no room");
}

Route::Route(const FreeSpace& space, const ViewArea& area, Random& random, const Pace& pace)
{
  places_.push_back(drawPose(space, area, random));
  arrivals_.push_back(0.0);
  while (places_.size() < kPlaces) {
    const RoutePose last = places_.back();
    RoutePose next = drawAnywhere(area, random);
    for (int i = 0; i < kLegTries && !space.containsSegment(last.position, next.position); ++i) {
      next = drawAnywhere(area, random);
    }
    // Where no straight way leads on, look around from here.
    if (!space.containsSegment(last.position, next.position)) next.position = last.position;
    const double duration = std::max((next.position - last.position).norm() / pace.speed,
                                     std::abs(next.yaw - last.yaw) / pace.turn_rate);
    arrivals_.push_back(arrivals_.back() + std::max(1.0, kPeak * duration));
    places_.push_back(next);
  }
}

RoutePose Route::at(double time) const
{
  const double end = arrivals_.back();
  double t = std::fmod(time, 2.0 * end);
  if (t > end) t = 2.0 * end - t;
  const auto next = std::upper_bound(arrivals_.begin() + 1, arrivals_.end() - 1, t);
  const auto leg = static_cast<std::size_t>(next - arrivals_.begin());
  const double part = (t - arrivals_[leg - 1]) / (arrivals_[leg] - arrivals_[leg - 1]);
  const double eased = part * part * (3.0 - 2.0 * part);
  const RoutePose& from = places_[leg - 1];
  const RoutePose& to = places_[leg];
  return {from.position + eased * (to.position - from.position), from.yaw + eased * (to.yaw - from.yaw)};
}

}  // namespace simulation
}  // namespace polygonal_perception
