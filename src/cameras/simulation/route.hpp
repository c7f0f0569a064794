#pragma once

#include <vector>

#include "cameras/simulation/free_space.hpp"
#include "polygonal_perception/cameras/simulation/random.hpp"
#include "polygonal_perception/cameras/simulation/scene.hpp"

namespace polygonal_perception::simulation {

/// A free place in a view area.
/// @throws std::runtime_error when none is found
Waypoint drawPose(const FreeSpace& space, const ViewArea& area, Random& random);

/// A closed way through some places and back, easing in and out of each leg.
class Route
{
public:
  struct Pace
  {
    double speed = 0.3;      ///< [m/s]
    double turn_rate = 0.5;  ///< [rad/s]
  };

  Route() = default;
  /// Through places that it draws. In areas that are there to be looked at from all sides the camera looks where it
  /// goes and turns on the spot; in the others it keeps the area's headings, going sideways or backwards as Robotino
  /// and a hand can.
  Route(const FreeSpace& space, const ViewArea& area, Random& random, const Pace& pace);
  /// Through given places, at least two, looking where it goes.
  Route(std::vector<Waypoint> places, const Pace& pace);

  Waypoint at(double time) const;

private:
  void addLegs(std::vector<Waypoint> stops, bool looks_ahead, const Pace& pace);
  void addPlace(const Waypoint& place, const Pace& pace);

  std::vector<Waypoint> places_;  // the last is the first again
  std::vector<double> arrivals_;  // [s] at each place, the first at 0
};

}  // namespace polygonal_perception::simulation
