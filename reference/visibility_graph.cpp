#include "reference/visibility_graph.hpp"

#include <limits>

#include "reference/line_of_sight.hpp"

namespace polygonal_perception::reference {

VisibilityGraph::VisibilityGraph(const geometry::PolygonSet& obstacles)
    : obstacles_(obstacles), neighbours_(obstacles.vertices.size())
{
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    for (std::size_t j = i + 1; j < neighbours_.size(); ++j) {
      if (!sees(obstacles.vertices[i], obstacles.vertices[j])) continue;
      const double distance = (obstacles.vertices[i] - obstacles.vertices[j]).norm();
      neighbours_[i].push_back({j, distance});
      neighbours_[j].push_back({i, distance});
    }
  }
}

bool VisibilityGraph::sees(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const
{
  if (from == to) return true;
  for (const geometry::PolygonSet::Ring& ring : obstacles_.rings)
    if (blockedAt(obstacles_.view(ring), from, to)) return false;
  return true;
}

std::optional<double> VisibilityGraph::shortest(const Eigen::Vector2d& start,
                                                const Eigen::Vector2d& goal) const
{
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double best = sees(start, goal) ? (goal - start).norm() : kInfinity;
  const std::size_t count = neighbours_.size();
  std::vector<double> length(count, kInfinity);
  std::vector<bool> is_done(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (sees(start, obstacles_.vertices[i])) length[i] = (obstacles_.vertices[i] - start).norm();
  for (;;) {
    std::size_t next = count;
    for (std::size_t i = 0; i < count; ++i)
      if (!is_done[i] && length[i] < (next == count ? best : length[next])) next = i;
    if (next == count) break;
    is_done[next] = true;
    if (sees(obstacles_.vertices[next], goal))
      best = std::min(best, length[next] + (goal - obstacles_.vertices[next]).norm());
    for (const Neighbour& neighbour : neighbours_[next])
      length[neighbour.vertex] = std::min(length[neighbour.vertex], length[next] + neighbour.distance);
  }
  if (best == kInfinity) return std::nullopt;
  return best;
}

}  // namespace polygonal_perception::reference
