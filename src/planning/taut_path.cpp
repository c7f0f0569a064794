#include "polygonal_perception/planning/taut_path.hpp"

#include <algorithm>

namespace polygonal_perception::planning {

using geometry::orientation;
using geometry::Orientation;

double TautPath::pull(const geometry::TriangleMesh& mesh, const Sleeve& sleeve, const Eigen::Vector2d& start,
                      const Eigen::Vector2d& goal, std::vector<Eigen::Vector2d>& path)
{
  path.assign(1, start);
  left_.beginAt(start);
  right_.beginAt(start);
  for (const std::uint32_t half_edge : sleeve.crossed) {
    // Its triangle lies to the left of it, and who leaves it has the target to the left.
    extend(right_, left_, mesh.originPoint(half_edge), Orientation::kClockwise, path);
    extend(left_, right_, mesh.targetPoint(half_edge), Orientation::kCounterClockwise, path);
  }
  extend(left_, right_, goal, Orientation::kCounterClockwise, path);
  path.insert(path.end(), left_.points.begin() + static_cast<std::ptrdiff_t>(left_.apex) + 1,
              left_.points.end());
  path.erase(std::unique(path.begin(), path.end()), path.end());
  if (path.size() == 1) path.push_back(goal);

  double length = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) length += (path[i + 1] - path[i]).norm();
  return length;
}

void TautPath::extend(Chain& side, Chain& other, const Eigen::Vector2d& end, Orientation way,
                      std::vector<Eigen::Vector2d>& path)
{
  if (end == side.points.back()) return;
  while (!side.isApexAlone() &&
         orientation(side.points[side.points.size() - 2], side.points.back(), end) != way)
    side.points.pop_back();
  if (side.isApexAlone()) {
    const Orientation beyond_other =
        way == Orientation::kClockwise ? Orientation::kCounterClockwise : Orientation::kClockwise;
    while (!other.isApexAlone() &&
           orientation(other.points[other.apex], other.points[other.apex + 1], end) == beyond_other) {
      path.push_back(other.points[++other.apex]);
      side.beginAt(path.back());
    }
  }
  side.points.push_back(end);
}

}  // namespace polygonal_perception::planning
