#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

namespace polygonal_perception::plugins {

/// A path as local planners of move_base want it: they seek the pose nearest to the robot, cut off what is beyond their map,
/// and would find none on a long segment.
///
/// @param corners   [m] two or more
/// @param to_frame  takes them into the header's frame
/// @param spacing   [m] between poses, at most
/// @param goal_yaw  [rad] among the corners' axes; nothing: that of the last segment. The others look along their segments
/// @return corners included
std::vector<geometry_msgs::PoseStamped> densePlan(const std::vector<Eigen::Vector2d>& corners,
                                                  const Eigen::Isometry3d& to_frame, double spacing,
                                                  const std::optional<double>& goal_yaw,
                                                  const std_msgs::Header& header);

}  // namespace polygonal_perception::plugins
