#pragma once

#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/ros/common/parameter_list.hpp"

namespace polygonal_perception::ros_common {

/// What was wrong with the parameters on the server.
struct ParameterReport
{
  /// A text a parameter that is refused, with its name, its value and what is accepted; its default stays.
  std::vector<std::string> errors;
  /// Names in the namespace that are no parameter of the node: slips of the pen.
  std::vector<std::string> warnings;
};

/// Reads the parameters from a node's private namespace into a struct of defaults.
/// @param retired  names that are refused with the one that took their place
POLYGONAL_PERCEPTION_EXPORT ParameterReport
readParameters(const ros::NodeHandle& private_handle, ParameterList& parameters,
               const std::vector<parameters::RetiredName>& retired = {});

/// Writes the numbers that can be reconfigured to the parameter server, so that `rosparam get` shows what is
/// in force.
POLYGONAL_PERCEPTION_EXPORT void writeParameters(const ros::NodeHandle& private_handle,
                                                 const ParameterList& parameters);

}  // namespace polygonal_perception::ros_common
