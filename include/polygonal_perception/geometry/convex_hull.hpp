#pragma once

#include <Eigen/Core>
#include <vector>

#include "polygonal_perception/export.hpp"

namespace polygonal_perception::geometry {

/// The smallest convex polygon around points. Which points are its corners is decided without rounding
/// (within the limits of predicates.hpp).
///
/// @param points  in any order, also repeated; finite
/// @return its corners counter-clockwise, the one with the least x (then the least y) first, none in a
///         straight line with its neighbours; the two ends of points that lie on one line, the point of those
///         that are the same, nothing for none
POLYGONAL_PERCEPTION_EXPORT std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

}  // namespace polygonal_perception::geometry
