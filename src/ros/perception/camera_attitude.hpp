#pragma once

#include <Eigen/Core>

namespace polygonal_perception::ros_perception {

/// How the camera is held above the floor, in the sense of a body frame with x ahead, y left and z up.
struct CameraAttitude
{
  double pitch = 0.0;  ///< [rad] positive: it looks down
  double roll = 0.0;   ///< [rad] positive: its left side is up
};

/// @param floor_normal  unit, up, in the input's frame
/// @param forward       unit axis of the input's frame along which the camera looks
/// @param initial_up    up in the input's frame when the camera is level, any length
CameraAttitude cameraAttitude(const Eigen::Vector3d& floor_normal, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& initial_up);

}  // namespace polygonal_perception::ros_perception
