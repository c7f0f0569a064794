#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_driving {

/// The whole node that drives: what the nodelet and the program run, and what needs neither of them.
///
/// It gives a command a period, which follows the path among the polygons, or stops the robot and says why.
/// The handles' queue may be served by any thread, one callback at a time.
class POLYGONAL_PERCEPTION_EXPORT DynamicWindowNode
{
public:
  /// @param handle          where the inputs are, and cmd_vel
  /// @param private_handle  where parameters and the other outputs are
  DynamicWindowNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~DynamicWindowNode();
  DynamicWindowNode(const DynamicWindowNode&) = delete;
  DynamicWindowNode& operator=(const DynamicWindowNode&) = delete;

  /// The table of all parameters in Markdown. That in doc/driving.md must be this one.
  static std::string parameterTable();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::ros_driving
