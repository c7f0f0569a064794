#include "polygonal_perception/perception/floor/floor_hull.hpp"

#include <Eigen/Geometry>
#include <cstddef>
#include <utility>

#include "polygonal_perception/geometry/convex_hull.hpp"

namespace polygonal_perception::perception {

std::vector<Eigen::Vector3f> floorHull(const SampleGrid& samples, const std::vector<SampleLabel>& labels,
                                       const geometry::Plane& floor)
{
  // Two axes that span the plane, right-handed with the normal, so that counter-clockwise in them is so from
  // above.
  const Eigen::Vector3d axis_a = floor.normal.unitOrthogonal();
  const Eigen::Vector3d axis_b = floor.normal.cross(axis_a);

  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != SampleLabel::kFloor) continue;
    const Eigen::Vector3d point = samples.samples()[i].point.cast<double>();
    points.emplace_back(axis_a.dot(point), axis_b.dot(point));
  }
  const std::vector<Eigen::Vector2d> corners = geometry::convexHull(std::move(points));
  std::vector<Eigen::Vector3f> hull;
  if (corners.size() < 3) return hull;
  for (const Eigen::Vector2d& corner : corners) {
    hull.emplace_back(
        (corner.x() * axis_a + corner.y() * axis_b - floor.distance * floor.normal).cast<float>());
  }
  return hull;
}

}  // namespace polygonal_perception::perception
