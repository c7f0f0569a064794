#pragma once

#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <polygonal_perception/PolygonArray.h>
#include <polygonal_perception/TrackedPolygonArray.h>

#include <string>
#include <vector>

#include "polygonal_perception/planning/moving_edges.hpp"
#include "polygonal_perception/planning/robot_model.hpp"
#include "polygonal_perception/ros/common/expected.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"

namespace polygonal_perception::ros_driving {

/// A path in the frame of the odometry.
struct DrivenPath
{
  std::vector<Eigen::Vector2d> points;  ///< [m]
  double goal_yaw = 0.0;                ///< [rad]
};

/// Messages as the dynamic window takes them: in the frame of the odometry, with what is wrong with them.
class DriveInputs
{
public:
  using Edges = std::vector<planning::MovingEdge>;

  ros_common::Expected<Edges> standing(const PolygonArray& polygons, const std::string& frame) const;
  /// @param sigmas  of the velocity by which they grow
  ros_common::Expected<Edges> moving(const TrackedPolygonArray& polygons, double sigmas,
                                     const std::string& frame) const;
  /// Of a path with poses.
  ros_common::Expected<DrivenPath> path(const nav_msgs::Path& path, const std::string& frame) const;
  static ros_common::Expected<planning::RobotState> state(const nav_msgs::Odometry& odometry);

  void clear() { tf_.clear(); }

private:
  ros_common::Expected<Eigen::Isometry2d> place(const std_msgs::Header& header,
                                                const std::string& frame) const;

  ros_common::TfBridge tf_;
};

}  // namespace polygonal_perception::ros_driving
