#include "reference/arc_march.hpp"

#include <algorithm>

#include "polygonal_perception/geometry/distance.hpp"
#include "polygonal_perception/geometry/location.hpp"

namespace polygonal_perception::reference {

double depthIn(const MovingObstacles& obstacles, const Eigen::Vector2d& point, double time)
{
  const Eigen::Vector2d place = point - time * obstacles.velocity;
  const double distance = geometry::distanceToBoundary(place, obstacles.polygons);
  const bool is_inside = geometry::locate(place, obstacles.polygons) == geometry::Location::kInside;
  return (is_inside ? distance : -distance) + obstacles.growth * time;
}

std::optional<double> marchToContact(const planning::Arc& arc, const MovingObstacles& obstacles, double until,
                                     double step)
{
  const double fastest = arc.speed() + obstacles.velocity.norm() + obstacles.growth;
  for (double time = arc.begin(); time <= until;) {
    const double depth = depthIn(obstacles, arc.position(time), time);
    if (depth > 0.0) return time;
    time += fastest > 0.0 ? std::max(step, -depth / fastest) : until;
  }
  return std::nullopt;
}

}  // namespace polygonal_perception::reference
