#include "polygonal_perception/perception/floor/floor_hull.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <tuple>

namespace polygonal_perception::perception {

namespace {

/// Twice the area of the triangle a, b, c; positive when it runs counter-clockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Andrew's monotone chain.
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
  });
  std::vector<Eigen::Vector2d> hull;
  const auto extend = [&hull](std::size_t base, const Eigen::Vector2d& point) {
    while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
    hull.push_back(point);
  };
  for (const Eigen::Vector2d& point : points) extend(0, point);
  const std::size_t lower = hull.empty() ? 0 : hull.size() - 1;
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    if (point != points.rbegin()) extend(lower, *point);
  }
  if (!hull.empty()) hull.pop_back();
  if (hull.size() < 3) hull.clear();
  return hull;
}

}  // namespace

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
  std::vector<Eigen::Vector3f> hull;
  for (const Eigen::Vector2d& corner : convexHull(std::move(points))) {
    hull.emplace_back(
        (corner.x() * axis_a + corner.y() * axis_b - floor.distance * floor.normal).cast<float>());
  }
  return hull;
}

}  // namespace polygonal_perception::perception
