#pragma once

#include <vector>

#include "free_space.hpp"
#include "polygonal_perception/simulation/random.hpp"

namespace polygonal_perception {
namespace simulation {

struct RoutePose
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< [rad]
};

/// A free place in a view area.
/// @throws std::runtime_error when none is found
RoutePose drawPose(const FreeSpace& space, const ViewArea& area, Random& random);

/// A way through some places and back again, for ever, easing in and out of each leg. The heading turns as
/// the place moves: Robotino and a hand can go sideways.
class Route
{
public:
  struct Pace
  {
    double speed = 0.3;      ///< [m/s]
    double turn_rate = 0.5;  ///< [rad/s]
  };

  Route() = default;
  Route(const FreeSpace& space, const ViewArea& area, Random& random, const Pace& pace);

  RoutePose at(double time) const;

private:
  std::vector<RoutePose> places_;
  std::vector<double> arrivals_;  // [s] at each place, the first at 0
};

}  // namespace simulation
}  // namespace polygonal_perception
