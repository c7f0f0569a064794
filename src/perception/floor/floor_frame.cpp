#include "polygonal_perception/perception/floor/floor_frame.hpp"

namespace polygonal_perception::perception {

Eigen::Isometry3d floorFrame(const geometry::Plane& floor, const ViewAxes& view)
{
  constexpr double kLookingStraightDown = 0.05;  // sine of about 3 degrees
  const Eigen::Vector3d& up = floor.normal;
  const auto along = [&up](const Eigen::Vector3d& axis) -> Eigen::Vector3d {
    return axis - axis.dot(up) * up;
  };
  Eigen::Vector3d ahead = along(view.forward);
  // The top of the image of a camera that looks down is ahead; under one that looks up it is behind.
  if (!(ahead.norm() > kLookingStraightDown))
    ahead = view.forward.dot(up) > 0.0 ? along(-view.upward) : along(view.upward);
  ahead.normalize();

  Eigen::Isometry3d to_floor = Eigen::Isometry3d::Identity();
  to_floor.linear().row(0) = ahead;
  to_floor.linear().row(1) = up.cross(ahead);
  to_floor.linear().row(2) = up;
  to_floor.translation() = Eigen::Vector3d(0.0, 0.0, floor.distance);
  return to_floor;
}

Eigen::Matrix3d tiltCovariance(const Eigen::Matrix4d& covariance, const Eigen::Isometry3d& to_floor_frame)
{
  // A small turn w of the normal z changes it by w x z = (w_y, -w_x, 0).
  Eigen::Matrix<double, 3, 4> jacobian = Eigen::Matrix<double, 3, 4>::Zero();
  jacobian.block<1, 3>(0, 0) = -to_floor_frame.linear().row(1);
  jacobian.block<1, 3>(1, 0) = to_floor_frame.linear().row(0);
  jacobian(2, 3) = 1.0;
  return jacobian * covariance * jacobian.transpose();
}

}  // namespace polygonal_perception::perception
