#pragma once

#include <optional>
#include <string>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/planning/path_parameters.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_planning {

/// Every parameter of the node.
struct ShortestPathParameters
{
  std::string robot_frame = "base_link";
  std::string fixed_frame = "odom";
  double tf_timeout = 0.1;  ///< [s]
  planning::PathParameters path;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    visit("robot_frame", self.robot_frame, ros_common::kFrame, "Paths begin at the origin of this frame.");
    visit(
        "fixed_frame", self.fixed_frame, ros_common::kFrame,
        "A goal in a frame that moves stays where it is in this one; where tf does not know it, in its own.");
    visit("tf_timeout", self.tf_timeout, Range{0.0, 1.0}.atStart(), "s",
          "How long polygons wait for the robot's transform.");
    planning::PathParameters::describe(self.path, visit);
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::ros_planning
