#include "planning/surroundings.hpp"

#include <limits>

#include "polygonal_perception/geometry/distance.hpp"

namespace polygonal_perception::planning {

namespace {

/// How an edge changes the winding number of a place: 1 where a ray to the right crosses it upwards, -1 downwards. Near
/// the edge rounding may be wrong, and there nobody asks.
int windings(const MovingEdge& edge, const Eigen::Vector2d& to, const Eigen::Vector2d& place)
{
  const bool is_above = edge.from.y() > place.y();
  if (is_above == (to.y() > place.y())) return 0;
  const double share = (place.y() - edge.from.y()) / (to.y() - edge.from.y());
  if (edge.from.x() + share * (to.x() - edge.from.x()) <= place.x()) return 0;
  return is_above ? -1 : 1;
}

}  // namespace

Surroundings surroundings(const Eigen::Vector2d& place, const std::vector<MovingEdge>& edges)
{
  Surroundings around;
  int winding = 0;
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector2d nearest = place;
  for (const MovingEdge& edge : edges) {
    const Eigen::Vector2d to = edge.from + edge.length * edge.along;
    winding += windings(edge, to, place);
    const Eigen::Vector2d on = geometry::nearestOnSegment(place, edge.from, to);
    const double distance = (on - place).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = on;
  }
  if (winding > 0 && least > 0.0) {
    around.depth = least;
    around.outward = (nearest - place) / least;
  }
  return around;
}

}  // namespace polygonal_perception::planning
