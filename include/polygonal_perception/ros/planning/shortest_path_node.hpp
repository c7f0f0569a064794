#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_planning {

/// The whole planner node: what the nodelet and the program run, and what needs neither of them.
///
/// It answers each PolygonArray with a path from the robot to the goal, and service calls with plans on the newest one.
/// The handles' queue may be served by any thread, one callback at a time.
class POLYGONAL_PERCEPTION_EXPORT ShortestPathNode
{
public:
  /// @param handle          where the inputs are
  /// @param private_handle  where parameters, outputs and services are
  ShortestPathNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~ShortestPathNode();
  ShortestPathNode(const ShortestPathNode&) = delete;
  ShortestPathNode& operator=(const ShortestPathNode&) = delete;

  /// The table of all parameters in Markdown. That in doc/paths.md must be this one.
  static std::string parameterTable();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::ros_planning
