#pragma once

#include <optional>

#include "polygonal_perception/geometry/polygon_set.hpp"
#include "polygonal_perception/planning/arc.hpp"

namespace polygonal_perception::reference {

/// Obstacles that move together.
struct MovingObstacles
{
  geometry::PolygonSet polygons;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double growth = 0.0;                                 ///< [m/s] to all sides
};

/// [m] How deep a point is in obstacles; negative outside, as far as it is from them.
double depthIn(const MovingObstacles& obstacles, const Eigen::Vector2d& point, double time);

/// When a point on an arc is first inside obstacles, by going along it in steps that are too short to miss them, and at least
/// as long as told.
///
/// @param step  [s]
/// @return [s] of the first step inside; nothing if it is outside at all times
std::optional<double> marchToContact(const planning::Arc& arc, const MovingObstacles& obstacles, double until,
                                     double step);

}  // namespace polygonal_perception::reference
