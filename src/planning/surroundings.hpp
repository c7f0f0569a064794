#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/planning/moving_edges.hpp"

namespace polygonal_perception::planning {

/// Where a robot stands among obstacles.
struct Surroundings
{
  double depth = 0.0;                                 ///< [m] inside an obstacle; 0 outside of all
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();  ///< the shortest way out, of length 1; 0 outside
};

/// At time 0, among obstacles that may overlap.
Surroundings surroundings(const Eigen::Vector2d& place, const std::vector<MovingEdge>& edges);

}  // namespace polygonal_perception::planning
