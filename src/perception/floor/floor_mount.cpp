#include "polygonal_perception/perception/floor/floor_mount.hpp"

#include <cmath>

#include "polygonal_perception/geometry/angle.hpp"

namespace polygonal_perception::perception {

MountError mountError(const DetectedFloor& floor, const geometry::Plane& mount,
                      const FloorMountParameters& parameters)
{
  const Eigen::Vector3d turn = floor.plane.normal - mount.normal;
  MountError error;
  error.mount = mount;
  error.tilt = geometry::angleBetween(floor.plane.normal, mount.normal);
  error.height = floor.plane.distance - mount.distance;
  const auto squared = [](double x) { return x * x; };
  // Along the direction in which the normal is off: what the floor's own covariance has there is its share.
  const Eigen::Vector3d direction = turn.norm() > 0.0 ? turn.normalized() : turn;
  const double tilt_variance = direction.dot(floor.covariance.topLeftCorner<3, 3>() * direction) +
                               squared(parameters.mount_tilt_sigma);
  const double height_variance = floor.covariance(3, 3) + squared(parameters.mount_height_sigma);
  const double limit = squared(parameters.disagreement_sigmas);
  error.is_beyond =
      squared(error.tilt) > limit * tilt_variance || squared(error.height) > limit * height_variance;
  return error;
}

DetectedFloor assumedFloor(const geometry::Plane& mount, const FloorMountParameters& parameters)
{
  DetectedFloor floor;
  floor.plane = mount;
  // A tilt moves the normal across itself.
  floor.covariance.topLeftCorner<3, 3>() =
      parameters.mount_tilt_sigma * parameters.mount_tilt_sigma *
      (Eigen::Matrix3d::Identity() - mount.normal * mount.normal.transpose());
  floor.covariance(3, 3) = parameters.mount_height_sigma * parameters.mount_height_sigma;
  return floor;
}

}  // namespace polygonal_perception::perception
