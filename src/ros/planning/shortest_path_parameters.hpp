#pragma once

#include <optional>
#include <string>

#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_planning {

inline bool isOutsideRule(const std::string& text)
{
  return text == "free" || text == "blocked";
}

/// Every parameter of the node.
struct ShortestPathParameters
{
  std::string robot_frame = "base_link";
  std::string fixed_frame = "odom";
  double tf_timeout = 0.1;  ///< [s]
  /// As far as polygons have grown by default (robot_radius): a goal at a wall becomes the nearest point before it.
  double goal_tolerance = 0.3;  ///< [m]
  std::string outside = "free";
  double side_hysteresis = 0.1;

  bool outsideIsFree() const { return outside == "free"; }

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
    visit("goal_tolerance", self.goal_tolerance, Range{0.0, 10.0}, "m",
          "How far from a goal that is inside an obstacle a path may end.");
    visit("outside", self.outside, parameters::TextRule{"free or blocked", isOutsideRule},
          "What lies beyond the polygons' extent, where nothing was looked at.");
    visit("side_hysteresis", self.side_hysteresis, Range{0.0, 1.0}, "share",
          "A path keeps to its side of each obstacle until one on another side is shorter by this share; "
          "with 0 each is the "
          "shortest.");
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::ros_planning
