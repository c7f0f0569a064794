#include "ros/perception/mount_error_text.hpp"

#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"
#include "ros/perception/camera_attitude.hpp"
#include "ros/perception/printed.hpp"

namespace polygonal_perception::ros_perception {

std::string mountErrorText(const perception::FloorState& floor, const Eigen::Vector3d& forward,
                           const Eigen::Vector3d& initial_up, const std::string& mount_frame)
{
  const perception::MountError& error = *floor.mount_error;
  const CameraAttitude seen = cameraAttitude(floor.floor.plane.normal, forward, initial_up);
  const CameraAttitude told = cameraAttitude(error.mount.normal, forward, initial_up);
  const double pitch = (seen.pitch - told.pitch) / geometry::kDegree;
  const double roll = std::remainder(seen.roll - told.roll, 2.0 * M_PI) / geometry::kDegree;
  return printed("the camera is tilted by %.1f degrees against mount_frame '",
                 error.tilt / geometry::kDegree) +
         mount_frame +
         printed("' (it looks %.1f degrees further %s and is rolled by %.1f) and %.3f m %s", std::abs(pitch),
                 pitch < 0.0 ? "up" : "down", std::abs(roll), std::abs(error.height),
                 error.height < 0.0 ? "lower" : "higher");
}

}  // namespace polygonal_perception::ros_perception
