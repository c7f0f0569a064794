#pragma once

#include <optional>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/planning/path_parameters.hpp"

namespace polygonal_perception::plugins {

/// Every parameter of PolygonalGlobalPlanner.
struct GlobalPlannerParameters
{
  /// Twenty frames of a map at 10 Hz; move_base plans again when they come back.
  double timeout = 2.0;  ///< [s]
  planning::PathParameters path;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    visit("timeout", self.timeout, parameters::Range{0.0, 3600.0}, "s",
          "There is no plan on polygons that are older, or as much ahead of the clock.");
    planning::PathParameters::describe(self.path, visit);
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::plugins
