#pragma once

#include <optional>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/planning/driving_parameters.hpp"

namespace polygonal_perception::ros_driving {

/// Every parameter of the node.
struct DynamicWindowParameters
{
  double control_frequency = 20.0;  ///< [Hz]
  /// A robot at 1 m/s has gone half a metre by then, and the other sensors of a robot have seen it.
  double timeout = 0.5;          ///< [s]
  double latency = 0.0;          ///< [s]
  double velocity_sigmas = 2.0;  ///< 95 of 100 errors are smaller
  planning::DrivingParameters driving;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    visit("control_frequency", self.control_frequency, Range{1.0, 200.0}.atStart(), "Hz",
          "Commands a second.");
    visit("timeout", self.timeout, Range{0.01, 10.0}, "s", "It stops where polygons or odometry are older.");
    visit("latency", self.latency, Range{0.0, 2.0}, "s",
          "How long it takes until the base does what a command says.");
    visit("velocity_sigmas", self.velocity_sigmas, Range{0.0, 10.0}, "",
          "What moves may be faster than it seems by so many standard deviations.");
    planning::DrivingParameters::describe(self.driving, visit);
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::ros_driving
