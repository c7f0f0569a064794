#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>

#include <Eigen/Geometry>
#include <string>

namespace polygonal_perception::ros_perception {

/// The pose of the floor frame in the output frame: x, y and yaw from localisation; roll, pitch and height
/// are the floor's (section IV).
///
/// The floor frame lies straight under the input frame, and its yaw is the one that brings what the floor and
/// what tf say of the camera's attitude together best.
///
/// @param input_to_output  from tf
/// @param input_to_floor   Pipeline::Result::to_floor_frame
Eigen::Isometry2d poseInOutputFrame(const Eigen::Isometry3d& input_to_output,
                                    const Eigen::Isometry3d& input_to_floor);

/// The floor frame as a child of the input's frame.
geometry_msgs::TransformStamped toTransform(const std_msgs::Header& input, const std::string& floor_frame,
                                            const Eigen::Isometry3d& input_to_floor);

}  // namespace polygonal_perception::ros_perception
