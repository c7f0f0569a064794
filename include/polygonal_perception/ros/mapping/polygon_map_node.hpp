#pragma once

#include <ros/node_handle.h>

#include <memory>
#include <string>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::ros_mapping {

/// The whole map node: what the nodelet and the program run, and what needs neither of them.
///
/// It takes in the observed cells of one or several sensors, whether or not anybody reads the map, and answers each with
/// the map after it. The handles' queue may be served by any thread, one callback at a time.
class POLYGONAL_PERCEPTION_EXPORT PolygonMapNode
{
public:
  /// @param handle          where the inputs are
  /// @param private_handle  where parameters, outputs and services are
  PolygonMapNode(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle);
  ~PolygonMapNode();
  PolygonMapNode(const PolygonMapNode&) = delete;
  PolygonMapNode& operator=(const PolygonMapNode&) = delete;

  /// The table of all parameters in Markdown. The README's must be this one.
  static std::string parameterTable();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace polygonal_perception::ros_mapping
