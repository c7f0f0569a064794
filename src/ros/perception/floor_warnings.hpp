#pragma once

#include <ros/time.h>

#include <string>

#include "polygonal_perception/perception/pipeline.hpp"
#include "polygonal_perception/ros/common/lasting_condition.hpp"
#include "polygonal_perception/ros/common/throttled_log.hpp"

namespace polygonal_perception::ros_perception {

/// Says in the log what is wrong with the floor. A robot loses its floor before every wall, and leans at every kerb: only
/// what lasts is worth a warning, one.
class FloorWarnings
{
public:
  /// @param log  must outlive it
  explicit FloorWarnings(ros_common::ThrottledLog& log) : log_(log) {}

  void update(const perception::Pipeline::Result& result, const Eigen::Vector3d& initial_up,
              const std::string& mount_frame, const ros::Time& stamp);

  /// Nobody looked for a floor in a pause.
  void reset();

private:
  ros_common::ThrottledLog& log_;
  ros_common::LastingCondition missing_{ros::Duration(5.0)};
  ros_common::LastingCondition elsewhere_{ros::Duration(5.0)};
  ros_common::LastingCondition tilted_{ros::Duration(30.0)};  // robots wait before ramps
  ros_common::LastingCondition disagrees_{ros::Duration(2.0)};
};

}  // namespace polygonal_perception::ros_perception
