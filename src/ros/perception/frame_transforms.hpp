#pragma once

#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"
#include "polygonal_perception/perception/input/ignored_boxes.hpp"
#include "polygonal_perception/ros/common/tf_bridge.hpp"
#include "ros/perception/perception_parameters.hpp"

namespace polygonal_perception::ros_perception {

/// What tf says of a frame at its stamp, as far as the parameters ask it.
struct FrameTransforms
{
  perception::FloorHints hints;
  perception::IgnoredBoxes ignored;
  std::optional<Eigen::Isometry3d> input_to_output;
  std::string missing_input;   ///< why what the frame is looked at with is not there, or empty
  std::string missing_output;  ///< why the place of the outputs is not, or empty

  /// Why anything is missing, or empty.
  const std::string& missing() const { return missing_output.empty() ? missing_input : missing_output; }
};

/// @param tf          needed where the parameters name a frame (PerceptionParameters::needsTf())
/// @param needs_seed  whether the frame wants an up vector to begin with
FrameTransforms lookUpTransforms(const PerceptionParameters& parameters, const ros_common::TfBridge* tf,
                                 const std_msgs::Header& header, bool needs_seed);

}  // namespace polygonal_perception::ros_perception
