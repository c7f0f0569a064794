#include "polygonal_perception/cameras/simulation/scene_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace polygonal_perception::simulation {

ScenePlanes::ScenePlanes(const std::vector<Solid>& solids)
{
  for (const Solid& solid : solids) {
    for (const auto& triangle : solid.triangles) {
      if (solid.curved) {
        of_triangles_.push_back(kNone);
        continue;
      }
      const Eigen::Vector3d a = solid.vertices[triangle[0]].cast<double>();
      const Eigen::Vector3d b = solid.vertices[triangle[1]].cast<double>();
      const Eigen::Vector3d c = solid.vertices[triangle[2]].cast<double>();
      const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
      of_triangles_.push_back(numberOf({normal, -normal.dot((a + b + c) / 3.0)}));
    }
  }
}

std::uint16_t ScenePlanes::numberOf(const geometry::Plane& plane)
{
  // What rounding of vertices some metres away leaves.
  constexpr double kSameNormal = 1e-4;
  constexpr double kSameDistance = 1e-4;  // [m]
  const auto same = std::find_if(planes_.begin(), planes_.end(), [&](const geometry::Plane& known) {
    const double side = known.normal.dot(plane.normal) < 0.0 ? -1.0 : 1.0;
    return (known.normal - side * plane.normal).norm() < kSameNormal &&
           std::abs(known.distance - side * plane.distance) < kSameDistance;
  });
  if (same != planes_.end()) return static_cast<std::uint16_t>(same - planes_.begin() + 1);
  planes_.push_back(plane);
  return static_cast<std::uint16_t>(planes_.size());
}

}  // namespace polygonal_perception::simulation
