#include "polygonal_perception/planning/remaining_path.hpp"

#include <limits>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/predicates.hpp"

namespace polygonal_perception::planning {

using geometry::orientation;
using geometry::Orientation;

void RemainingPath::setPath(const std::vector<Eigen::Vector2d>& path)
{
  points_.assign(path.begin(), path.end());
  rest_.assign(points_.size(), 0.0);
  for (std::size_t i = points_.size(); i-- > 1;)
    rest_[i - 1] = rest_[i] + (points_[i] - points_[i - 1]).norm();
}

void RemainingPath::setPath(const Eigen::Vector2d& start, const Eigen::Vector2d& goal)
{
  points_.assign({start, goal});
  rest_.assign({(goal - start).norm(), 0.0});
}

RemainingPath::Way RemainingPath::from(const Eigen::Vector2d& place, double ahead) const
{
  const std::size_t first = firstBend(place);
  Way way{(points_[first] - place).norm() + rest_[first], points_[first]};
  Eigen::Vector2d from = place;
  for (std::size_t i = first; i < points_.size(); ++i) {
    const double length = (points_[i] - from).norm();
    if (length >= ahead) {
      way.ahead = from + ahead / length * (points_[i] - from);
      return way;
    }
    ahead -= length;
    from = points_[i];
  }
  way.ahead = goal();
  return way;
}

std::size_t RemainingPath::firstBend(const Eigen::Vector2d& place) const
{
  // What lies before the nearest piece of the path has been passed.
  std::size_t ahead = points_.size() - 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double distance =
        (geometry::nearestOnSegment(place, points_[i - 1], points_[i]) - place).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    ahead = i;
  }
  // A corner holds the thread where it still bends there as the path does.
  for (std::size_t i = ahead; i + 1 < points_.size(); ++i) {
    const Orientation bend = orientation(points_[i - 1], points_[i], points_[i + 1]);
    if (bend != Orientation::kCollinear && orientation(place, points_[i], points_[i + 1]) == bend) return i;
  }
  return points_.size() - 1;
}

}  // namespace polygonal_perception::planning
