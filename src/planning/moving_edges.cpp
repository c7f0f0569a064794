#include "polygonal_perception/planning/moving_edges.hpp"

namespace polygonal_perception::planning {

MovingEdge advanced(const MovingEdge& edge, double time)
{
  const double grown = edge.growth * time;
  MovingEdge later = edge;
  later.from += time * edge.velocity - grown * (edge.normal() + edge.along);
  later.length += 2.0 * grown;
  return later;
}

void appendMovingEdges(const geometry::PolygonSet& obstacles, const Eigen::Vector2d& velocity, double growth,
                       std::vector<MovingEdge>& edges)
{
  for (const geometry::PolygonSet::Ring& ring : obstacles.rings) {
    const std::size_t first = edges.size();
    for (const auto [from, to] : obstacles.view(ring).edges()) {
      const double length = (to - from).norm();
      if (length > 0.0) edges.push_back({from, (to - from) / length, length, velocity, growth});
    }
    if (growth == 0.0) continue;
    const std::size_t end = edges.size();
    for (std::size_t k = first; k < end; ++k) {
      const MovingEdge& edge = edges[k];
      const Eigen::Vector2d& next = edges[k + 1 == end ? first : k + 1].along;
      // A left turn of more than a right angle, which is where an obstacle sticks out.
      const double turn = edge.along.x() * next.y() - edge.along.y() * next.x();
      if (turn < 0.0 || edge.along.dot(next) >= 0.0) continue;
      const Eigen::Vector2d between = edge.along + next;
      const double length = between.norm();
      const Eigen::Vector2d along = length > 0.0 ? Eigen::Vector2d(between / length) : edge.normal();
      edges.push_back({edge.from + edge.length * edge.along, along, 0.0, velocity, growth});
    }
  }
}

}  // namespace polygonal_perception::planning
