#include "polygonal_perception/planning/side_keeper.hpp"

#include <algorithm>
#include <limits>

#include "planning/interval_length.hpp"
#include "polygonal_perception/geometry/distance.hpp"

namespace polygonal_perception::planning {

using geometry::TriangleMesh;

void SideKeeper::makeGuide(const TriangleMesh& mesh, const Sleeve& sleeve,
                           const std::vector<Eigen::Vector2d>& path, std::vector<Eigen::Vector2d>& guide)
{
  guide.assign(1, path.front());
  std::size_t segment = 0;
  for (const std::uint32_t edge : sleeve.crossed) {
    const Eigen::Vector2d& from = mesh.originPoint(edge);
    const Eigen::Vector2d& to = mesh.targetPoint(edge);
    // Around a corner edges lead away from it.
    if (segment + 2 < path.size() && (from == path[segment + 1] || to == path[segment + 1])) ++segment;
    const double length = (to - from).norm();
    const double room = std::min(kClearance, length / 2.0);
    const Eigen::Vector2d crossed = lineCrossing(path[segment], path[segment + 1], from, to);
    const double place = std::clamp((crossed - from).norm(), room, length - room);
    guide.push_back(from + place / length * (to - from));
  }
  guide.push_back(path.back());
}

std::optional<double> SideKeeper::follow(const FreeSpace& space, const FreePlace& start,
                                         const FreePlace& goal, const std::vector<Eigen::Vector2d>& guide,
                                         std::vector<Eigen::Vector2d>& path, Sleeve& sleeve)
{
  if (guide.size() < 2) return std::nullopt;
  std::size_t ahead = 0;
  Eigen::Vector2d nearest = guide.front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < guide.size(); ++i) {
    const Eigen::Vector2d place = geometry::nearestOnSegment(start.point, guide[i], guide[i + 1]);
    const double distance = (place - start.point).squaredNorm();
    if (distance > least) continue;
    least = distance;
    nearest = place;
    ahead = i + 1;
  }
  line_.assign({start.point, nearest});
  line_.insert(line_.end(), guide.begin() + static_cast<std::ptrdiff_t>(ahead), guide.end() - 1);
  line_.push_back(goal.point);
  line_.erase(std::unique(line_.begin(), line_.end()), line_.end());
  if (!tracer_.trace(space, start, goal, line_, sleeve)) return std::nullopt;
  return taut_path_.pull(space.mesh(), sleeve, start.point, goal.point, path);
}

}  // namespace polygonal_perception::planning
