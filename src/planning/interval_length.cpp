#include "planning/interval_length.hpp"

#include <algorithm>

namespace polygonal_perception::planning {

namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

Eigen::Vector2d lineCrossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                             const Eigen::Vector2d& d)
{
  const double from_c = cross(b - a, c - a);
  const double from_d = cross(b - a, d - a);
  const double span = from_c - from_d;
  // Nearly along the line, rounding is all that is left.
  if (span == 0.0) return c;
  return c + std::clamp(from_c / span, 0.0, 1.0) * (d - c);
}

double lengthThrough(const Eigen::Vector2d& right, const Eigen::Vector2d& left, const Eigen::Vector2d& root,
                     const Eigen::Vector2d& goal)
{
  const Eigen::Vector2d along = left - right;
  Eigen::Vector2d behind = goal;
  if (cross(along, goal - right) > 0.0 && along.squaredNorm() > 0.0) {
    const Eigen::Vector2d normal(-along.y(), along.x());
    behind -= 2.0 * normal.dot(goal - right) / normal.squaredNorm() * normal;
  }
  const Eigen::Vector2d way = behind - root;
  if (cross(way, right - root) > 0.0) return (right - root).norm() + (behind - right).norm();
  if (cross(way, left - root) < 0.0) return (left - root).norm() + (behind - left).norm();
  return way.norm();
}

}  // namespace polygonal_perception::planning
