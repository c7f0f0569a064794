#include "ros/perception/camera_attitude.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::ros_perception {

CameraAttitude cameraAttitude(const Eigen::Vector3d& floor_normal, const Eigen::Vector3d& forward,
                              const Eigen::Vector3d& initial_up)
{
  const Eigen::Vector3d up = (initial_up - initial_up.dot(forward) * forward).normalized();
  const Eigen::Vector3d left = up.cross(forward);
  // The floor's normal in a body frame that is turned by Ry(pitch) Rx(roll) is (-sin p, cos p sin r, cos p
  // cos r).
  return {std::asin(std::clamp(-floor_normal.dot(forward), -1.0, 1.0)),
          std::atan2(floor_normal.dot(left), floor_normal.dot(up))};
}

}  // namespace polygonal_perception::ros_perception
