#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/mapping/polygon_map.hpp"
#include "polygonal_perception/parameters/parameter_check.hpp"
#include "polygonal_perception/parameters/parameter_table.hpp"
#include "polygonal_perception/ros/common/text_rules.hpp"

namespace polygonal_perception::ros_mapping {

/// Every parameter of the node: those that only the ROS side knows, and the map's.
struct PolygonMapParameters
{
  std::vector<std::string> sources;
  std::string fixed_frame = "odom";
  std::string robot_frame = "base_link";
  double tf_timeout = 0.1;  ///< [s]
  /// As old as an observation may be beside the newest one and still clear: what a slower sensor saw before may have been
  /// entered since.
  double max_delay = 0.3;  ///< [s]
  mapping::PolygonMap::Parameters map;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor&& visit)
  {
    using parameters::Range;
    visit("sources", self.sources,
          "Names of the sensors, each of which sends NAME/observed_cells; none: one, observed_cells.");
    visit("fixed_frame", self.fixed_frame, ros_common::kFrame,
          "Frame of the map: one that does not jump, as odom.");
    visit("robot_frame", self.robot_frame, ros_common::kFrame, "The map rolls with this frame.");
    visit("tf_timeout", self.tf_timeout, Range{0.0, 1.0}.atStart(), "s",
          "How long an observation waits for its transforms; others are not held up.");
    visit("max_delay", self.max_delay, Range{0.0, 10.0}, "s",
          "An observation that is so much older than the newest one clears nothing.");
    mapping::PolygonMap::Parameters::describe(self.map, visit);
  }

  std::optional<parameters::ParameterFault> conflict() const { return std::nullopt; }
};

}  // namespace polygonal_perception::ros_mapping
