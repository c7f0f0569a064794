#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/export.hpp"
#include "polygonal_perception/geometry/polygon_set.hpp"

namespace polygonal_perception::planning {

/// An edge of an obstacle that moves at a constant velocity, and grows. The obstacle lies to the left.
struct MovingEdge
{
  Eigen::Vector2d from = Eigen::Vector2d::Zero();      ///< [m] at time 0
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();    ///< of length 1
  double length = 0.0;                                 ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double growth = 0.0;                                 ///< [m/s] by which the obstacle grows to all sides

  /// Into the obstacle.
  Eigen::Vector2d normal() const { return {-along.y(), along.x()}; }
};

/// An edge some time later [s].
POLYGONAL_PERCEPTION_EXPORT MovingEdge advanced(const MovingEdge& edge, double time);

/// Appends the edges of obstacles that move together. Those that grow keep no gap at their corners: their edges grow longer
/// by as much as they move out, and where a corner is sharper than a right angle an edge of no length is put in, which cuts
/// the tip off.
///
/// @param obstacles  boundaries counter-clockwise, holes clockwise
/// @param velocity   [m/s] of them
/// @param growth     [m/s] >= 0, for what is not known of the velocity
POLYGONAL_PERCEPTION_EXPORT void appendMovingEdges(const geometry::PolygonSet& obstacles,
                                                   const Eigen::Vector2d& velocity, double growth,
                                                   std::vector<MovingEdge>& edges);

}  // namespace polygonal_perception::planning
