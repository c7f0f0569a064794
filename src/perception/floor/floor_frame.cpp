#include "polygonal_perception/perception/floor/floor_frame.hpp"

#include <cmath>

namespace polygonal_perception::perception {

Eigen::Isometry3d floorFrame(const geometry::Plane& floor, const Eigen::Vector3d& forward)
{
  constexpr double kLookingStraightDown = 0.02;  // sine of about 1 degree
  const Eigen::Vector3d& up = floor.normal;
  const Eigen::Vector3d direction = forward.normalized();
  Eigen::Vector3d ahead = direction - direction.dot(up) * up;
  // Also taken when `forward` is null or NaN.
  if (!(ahead.norm() > kLookingStraightDown)) {
    Eigen::Index flattest = 0;
    up.cwiseAbs().minCoeff(&flattest);
    ahead = Eigen::Vector3d::Unit(flattest);
    ahead -= ahead.dot(up) * up;
  }
  ahead.normalize();

  Eigen::Isometry3d to_floor = Eigen::Isometry3d::Identity();
  to_floor.linear().row(0) = ahead;
  to_floor.linear().row(1) = up.cross(ahead);
  to_floor.linear().row(2) = up;
  to_floor.translation() = Eigen::Vector3d(0.0, 0.0, floor.distance);
  return to_floor;
}

std::optional<Eigen::Vector3d> forwardAxis(const SampleGrid& samples, const Eigen::Vector3d& up)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Sample& sample : samples.samples()) {
    if (sample.has_point) sum += sample.point.cast<double>().normalized();
  }
  Eigen::Index vertical = 0;
  up.cwiseAbs().maxCoeff(&vertical);
  sum[vertical] = 0.0;
  Eigen::Index axis = 0;
  if (!(sum.cwiseAbs().maxCoeff(&axis) > 0.0)) return std::nullopt;
  return Eigen::Vector3d(std::copysign(1.0, sum[axis]) * Eigen::Vector3d::Unit(axis));
}

}  // namespace polygonal_perception::perception
