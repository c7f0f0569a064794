#include "polygonal_perception/geometry/convex_hull.hpp"

#include <algorithm>
#include <cstddef>

#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::geometry {

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points)
{
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;

  // Andrew's monotone chain: the lower side from left to right, then the upper side back.
  std::vector<Eigen::Vector2d> hull;
  const auto extend = [&hull](const Eigen::Vector2d& point, std::size_t start) {
    while (hull.size() >= start + 2 &&
           orientation(hull[hull.size() - 2], hull.back(), point) != Orientation::kCounterClockwise) {
      hull.pop_back();
    }
    hull.push_back(point);
  };
  for (const Eigen::Vector2d& point : points) extend(point, 0);
  const std::size_t upper = hull.size() - 1;
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point) extend(*point, upper);
  hull.pop_back();  // where it began
  return hull;
}

}  // namespace polygonal_perception::geometry
