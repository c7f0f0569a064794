#pragma once

#include "polygonal_perception/parameters/parameter_table.hpp"

namespace polygonal_perception::perception {

/// How far away a sensor's points are believed.
struct RangeLimits
{
  /// [m] Points nearer to the sensor are no points. Many drivers write (0, 0, 0) where there is no return.
  double min_range = 0.01;
  /// [m] Nor are points farther away; 0: no limit but the sensor's own.
  double max_range = 0.0;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("min_range", self.min_range, parameters::Range{0.0, 10.0}, "m",
          "Points nearer to the sensor are no points: its own housing, a bumper.");
    visit("max_range", self.max_range, parameters::Range{0.0, 300.0}, "m",
          "Points farther from the sensor are no points; 0: all are.");
  }
};

}  // namespace polygonal_perception::perception
