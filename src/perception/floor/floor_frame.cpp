#include "polygonal_perception/perception/floor/floor_frame.hpp"

#include <algorithm>
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

std::optional<Eigen::Vector3d> forwardAxis(const PointView& points, const SampleGrid& samples)
{
  // Garbage among the returns must not decide: so small a share of them counts for nothing.
  constexpr double kGarbage = 0.005;
  if (points.layout() != PointLayout::kCloud) return Eigen::Vector3d::UnitZ();

  // Those of optical and body frames come first.
  const std::array<Eigen::Vector3f, 6> axes = {Eigen::Vector3f::UnitZ(),  Eigen::Vector3f::UnitX(),
                                               -Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
                                               -Eigen::Vector3f::UnitY(), -Eigen::Vector3f::UnitZ()};
  std::array<int, 6> ahead{};
  int returns = 0;
  for (const Sample& sample : samples.samples()) {
    if (!sample.has_point || sample.point.isZero()) continue;
    ++returns;
    for (std::size_t k = 0; k < axes.size(); ++k) ahead[k] += axes[k].dot(sample.point) > 0.0F ? 1 : 0;
  }
  if (returns == 0) return std::nullopt;
  const double enough = *std::max_element(ahead.begin(), ahead.end()) - kGarbage * returns;
  const auto first =
      std::find_if(ahead.begin(), ahead.end(), [enough](int count) { return count >= enough; });
  return axes[static_cast<std::size_t>(first - ahead.begin())].cast<double>();
}

}  // namespace polygonal_perception::perception
