#include "polygonal_perception/perception/floor/floor_frame.hpp"

#include <array>
#include <cmath>
#include <cstddef>

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

Eigen::Matrix3d tiltCovariance(const Eigen::Matrix4d& covariance, const Eigen::Isometry3d& to_floor_frame)
{
  // A small turn w of the normal z changes it by w x z = (w_y, -w_x, 0).
  Eigen::Matrix<double, 3, 4> jacobian = Eigen::Matrix<double, 3, 4>::Zero();
  jacobian.block<1, 3>(0, 0) = -to_floor_frame.linear().row(1);
  jacobian.block<1, 3>(1, 0) = to_floor_frame.linear().row(0);
  jacobian(2, 3) = 1.0;
  return jacobian * covariance * jacobian.transpose();
}

std::optional<Eigen::Vector3d> forwardAxis(const PointView& points, const SampleGrid& samples,
                                           const Eigen::Vector3d& up)
{
  // Garbage among the returns must not decide: so small a share of them counts for nothing.
  constexpr double kGarbage = 0.005;
  constexpr float kVertical = 0.7F;         // cosine of 45 degrees
  constexpr std::size_t kConventional = 2;  // axes that a camera may look along by convention, whatever is up
  if (points.layout() != PointLayout::kCloud) return Eigen::Vector3d::UnitZ();

  // Those of optical and body frames come first.
  const std::array<Eigen::Vector3f, 6> axes = {Eigen::Vector3f::UnitZ(),  Eigen::Vector3f::UnitX(),
                                               -Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
                                               -Eigen::Vector3f::UnitY(), -Eigen::Vector3f::UnitZ()};
  std::array<double, 6> ahead{};  // returns before the plane across each axis
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  int returns = 0;
  for (const Sample& sample : samples.samples()) {
    if (!sample.has_point || sample.point.isZero()) continue;
    ++returns;
    mean += sample.point.normalized();
    for (std::size_t k = 0; k < axes.size(); ++k) ahead[k] += axes[k].dot(sample.point) > 0.0F ? 1.0 : 0.0;
  }
  if (returns == 0) return std::nullopt;

  const Eigen::Vector3f vertical = up.normalized().cast<float>();
  std::size_t best = axes.size();
  float along_best = 0.0F;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    if (k >= kConventional && std::abs(axes[k].dot(vertical)) > kVertical) continue;
    if (ahead[k] >= (1.0 - kGarbage) * returns) return axes[k].cast<double>();
    const float along = axes[k].dot(mean);
    if (best < axes.size() && along <= along_best) continue;
    best = k;
    along_best = along;
  }
  return axes[best].cast<double>();
}

}  // namespace polygonal_perception::perception
