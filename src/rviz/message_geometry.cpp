#include "rviz/message_geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::displays {

namespace {

bool isFinite(const geometry_msgs::Point32& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Eigen::Vector3d normalOf(const FloorPlane& floor)
{
  return {floor.normal.x, floor.normal.y, floor.normal.z};
}

}  // namespace

bool isDrawable(const FloorPlane& floor)
{
  constexpr double kUnitTolerance = 1e-3;
  // Written so that a normal or a distance of NaN fails.
  return std::abs(normalOf(floor).norm() - 1.0) < kUnitTolerance && std::isfinite(floor.distance) &&
         std::all_of(floor.hull.begin(), floor.hull.end(), isFinite);
}

Eigen::Vector3d footOf(const FloorPlane& floor)
{
  return -floor.distance * normalOf(floor);
}

std::vector<Eigen::Vector3d> hullOf(const FloorPlane& floor)
{
  std::vector<Eigen::Vector3d> hull;
  hull.reserve(floor.hull.size());
  for (const geometry_msgs::Point32& p : floor.hull) hull.emplace_back(p.x, p.y, p.z);
  return hull;
}

std::vector<Eigen::Vector3d> patchOf(const FloorPlane& floor, double size)
{
  const Eigen::Vector3d normal = normalOf(floor);
  const Eigen::Vector3d foot = footOf(floor);
  Eigen::Vector3d middle = foot;
  const std::vector<Eigen::Vector3d> hull = hullOf(floor);
  if (!hull.empty()) {
    middle.setZero();
    for (const Eigen::Vector3d& corner : hull) middle += corner / static_cast<double>(hull.size());
    middle -= (normal.dot(middle) + floor.distance) * normal;
  }
  // The camera looks from above its foot to what it sees of the floor.
  Eigen::Vector3d forward = middle - foot;
  forward = forward.norm() > 1e-6 ? forward.normalized() : normal.unitOrthogonal();
  const Eigen::Vector3d left = normal.cross(forward);
  const double half = size / 2.0;
  return {middle + half * (forward + left), middle + half * (left - forward),
          middle - half * (forward + left), middle + half * (forward - left)};
}

}  // namespace polygonal_perception::displays
