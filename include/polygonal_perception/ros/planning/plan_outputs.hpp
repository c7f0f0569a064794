#pragma once

#include <nav_msgs/Path.h>
#include <std_msgs/Header.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/planning/path_planner.hpp"
#include "polygonal_perception/ros/common/output_table.hpp"

namespace polygonal_perception::ros_planning {

/// What there is to say about a goal and one PolygonArray.
struct PlanResult
{
  std_msgs::Header header;  ///< stamp and frame of the polygons
  std::uint8_t status;      ///< as PlanStatus.status
  std::string message;
  const planning::Plan& plan;      ///< without a path unless the status is OK
  std::optional<double> goal_yaw;  ///< [rad] nothing: that of the last segment
  const planning::PathSearch& search;
};

using PlanOutputs = ros_common::OutputTable<PlanResult, ros_common::NoNeeds>;

/// Adds the topics of the node: path, status, markers.
POLYGONAL_PERCEPTION_EXPORT void addOutputs(PlanOutputs& outputs);

/// A path with each pose's yaw along the segment that begins there, and at its end the goal's own, if it has one.
POLYGONAL_PERCEPTION_EXPORT nav_msgs::Path toPath(const std_msgs::Header& header,
                                                  const std::vector<Eigen::Vector2d>& corners,
                                                  const std::optional<double>& goal_yaw);

}  // namespace polygonal_perception::ros_planning
