#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_perception {

/// The whole node: what the nodelet and the program run, and what needs neither of them.
///
/// It subscribes to the camera while somebody reads an output, answers each frame, and lets a frame whose
/// transforms are on their way wait without holding up anything else. The handles' queue may be served by any
/// thread, one callback at a time.
class POLYGONAL_PERCEPTION_EXPORT PerceptionNode
{
public:
  /// @param handle          where the inputs are
  /// @param private_handle  where parameters, outputs and services are
  PerceptionNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~PerceptionNode();
  PerceptionNode(const PerceptionNode&) = delete;
  PerceptionNode& operator=(const PerceptionNode&) = delete;

  /// The table of all parameters in Markdown. The README's must be this one.
  static std::string parameterTable();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::ros_perception
