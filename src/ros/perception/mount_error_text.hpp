#pragma once

#include <Eigen/Core>
#include <string>

#include "polygonal_perception/perception/floor/floor_tracker.hpp"

namespace polygonal_perception::ros_perception {

/// How a camera stands beside what its mount says, in a sentence: "the camera has tilted ...".
/// @param floor       FOUND, with a mount error
/// @param forward     unit axis of the input's frame along which the camera looks
/// @param initial_up  up in the input's frame when the camera is level, any length
std::string mountErrorText(const perception::FloorState& floor, const Eigen::Vector3d& forward,
                           const Eigen::Vector3d& initial_up, const std::string& mount_frame);

}  // namespace polygonal_perception::ros_perception
