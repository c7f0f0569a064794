#pragma once

#include <vector>

#include "cameras/simulation/free_space.hpp"
#include "polygonal_perception/cameras/simulation/random.hpp"

namespace polygonal_perception::simulation {

struct RoutePose
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  double yaw = 0.0;                                    ///< [rad]
};

/// A free place in a view area.
/// @throws std::runtime_error when none is found
RoutePose drawPose(const FreeSpace& space, const ViewArea& area, Random& random);

/// A closed way through some places, easing in and out of each leg. In areas that are there to be looked at
/// from all sides the camera looks where it goes and turns on the spot; in the others it keeps the area's
/// headings, going sideways or backwards as Robotino and a hand can.
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
  void addPlace(const RoutePose& place, const Pace& pace);

  std::vector<RoutePose> places_;  // the last is the first again
  std::vector<double> arrivals_;   // [s] at each place, the first at 0
};

}  // namespace polygonal_perception::simulation
